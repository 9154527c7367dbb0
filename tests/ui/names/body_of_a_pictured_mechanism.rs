use reuleaux::picture::Drawable;

reuleaux::mechanism! {
    #[picture]
    pub mechanism Feed {
        body table { point A = (20mm, 0mm); }
        joint rail = translational((1, 0), (0mm, 0mm), table.position);
        drive feed = drive_along(rail, 10mm_s * t);
    }
}

fn main() {
    let mechanism = Feed::default();
    let state = mechanism.solve(0.5).unwrap();
    let _: String = mechanism.picture(&state);
}
