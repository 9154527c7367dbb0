reuleaux::mechanism! {
    pub mechanism Tree {
        part trunk = Branch(ground.position);
        component Branch(root: Point) {
            body wood { point end = (1m, 0m); }
            joint w = weld(root, wood.position);
            part twig = Branch(wood.end);
        }
    }
}

fn main() {}
