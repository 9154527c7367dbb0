//! Components of another crate, against closed forms.

use reuleaux::{Description, Mechanism};

reuleaux::mechanism! {
    mechanism Reach {
        use elsewhere::{Chain, Link as Boom};
        // Names that the components have as well, and do not see.
        let length = 7m;
        let i = 3;
        param end: Length = 1m;
        part boom = Boom((end, length * i / 21), 90deg, speed: 2rad_s);
        part chain = Chain(boom.bar.end);
        output tip = chain.link[2].bar.end;
    }
}

reuleaux::constraint! {
    /// Not what the components of the other crate call by this name.
    constraint pinned(P: Point, Q: Point) { Q.x - P.x == 3m; Q.y == P.y; }

    /// The name of a component, too.
    constraint Link(P: Point, Q: Point) { Q.x == P.x; Q.y - P.y == 2m; }
}

reuleaux::mechanism! {
    mechanism Apart {
        use elsewhere::Link as Boom;
        use crate::components::imported::{Link, pinned, pinned as revolute};
        part boom = Boom((0m, 0m), 0);
        body end {}
        joint away = pinned(boom.bar.end, end.position);
        drive level = drive_angle(end, 0);
        body above {}
        joint over = Link(end.position, above.position);
        drive upright = drive_angle(above, 0);
        body beyond {}
        joint further = revolute(above.position, beyond.position);
        drive even = drive_angle(beyond, 0);
        output end = beyond.position;
    }
}

reuleaux::mechanism! {
    mechanism Two {
        use elsewhere::columns::Pile;
        use elsewhere::hanging::Pile as Drop;
        part pile = Pile((0m, 0m), 30mm);
        part drop = Drop((0m, 0m), 40mm);
    }
}

reuleaux::mechanism! {
    /// Of a bundle, what is for space.
    mechanism Slide in space {
        use elsewhere::columns;
        body slide {}
        joint way = along_x((0m, 1m, 2m), slide.position);
        joint square = { slide.orientation == turn((0, 0, 1), 0rad); }
        drive go = drive_x(slide.position, 1m_s * t);
    }
}

reuleaux::mechanism! {
    mechanism Both {
        use elsewhere::{Chain, Link};
        part chain = Chain((0m, 0m));
        part link = Link(chain.last.position, 0);
    }
}

reuleaux::mechanism! {
    mechanism Piles {
        use elsewhere::columns::Pile;
        part one = Pile((0mm, 0mm), 30mm);
        part two = Pile(one.top.position, 40mm);
        output top = two.top.position;
    }
}

reuleaux::mechanism! {
    mechanism Pendulums {
        use elsewhere::Pendulum;
        gravity = (0m_s2, -9.81m_s2);
        for i in 0..2 { part left[i] = Pendulum((1m * i, 0m)); }
    }
}

reuleaux::mechanism! {
    mechanism Turned in space {
        use elsewhere::Crank;
        ground { point O = (1m, 2m, 3m);  axis u = (1, 0, 0) from (0, 1, 0); }
        part crank = Crank(ground.O, ground.u);
        output end = crank.bar.end;
    }
}

/// A vector of this length and direction.
fn polar(length: f64, angle: f64) -> [f64; 2] {
    [length * angle.cos(), length * angle.sin()]
}

#[test]
fn links_of_another_crate_reach_where_their_sum_is() {
    let mut reach = Reach::default();
    (reach.boom.length, reach.chain.link[1].length) = (0.4, 0.2);
    for step in 0..20 {
        let t = f64::from(step) / 7.0;
        let state = reach.solve(t).expect("drives turn everything");
        let ten = 10_f64.to_radians();
        let angles = [2.0 * t, t, ten + 2.0 * t, 2.0 * ten + 3.0 * t];
        let links = [[-0.4 * angles[0].sin(), 0.4 * angles[0].cos()], polar(0.1, angles[1]), polar(0.2, angles[2]), polar(0.1, angles[3])];
        let sum = links.iter().fold([1.0, 1.0], |sum, link| [sum[0] + link[0], sum[1] + link[1]]);
        let tip = reach.tip(&state).value;
        assert!((tip.x - sum[0]).abs() < 1e-15 * 4.0 && (tip.y - sum[1]).abs() < 1e-15 * 4.0, "at {t}: {tip:?} is not {sum:?}");
        assert!((state.chain().last().angle - (1.0 - t.cos())).abs() < 1e-15);
        let (varied, state) = reach.derivatives(&state, |m| [&mut m.chain.link[1].length]).expect("it is regular");
        let by = varied.tip(&ReachState(state)).value;
        let direction = polar(1.0, angles[2]);
        assert!((by.x.by[0] - direction[0]).abs() < 1e-15 && (by.y.by[0] - direction[1]).abs() < 1e-15);
    }
}

#[test]
fn generated_structs_have_the_names_of_the_use_item() {
    let one = ReachBoom { length: 0.1 };
    assert!(one == Reach::default().boom && one < ReachBoom { length: 0.2 });
    assert_eq!(Reach::default().chain, ReachChain { link: [ReachLink { length: 0.1 }; 3] });
    let rows = <Reach as Description<f64, 15>>::ROWS;
    assert_eq!((rows[0].joint, rows[14].joint), ("boom.pin", "chain.wave"));
}

#[test]
fn a_component_that_comes_twice_is_one() {
    let Both { link, chain } = Both::<f64>::default();
    assert_eq!((link, chain.link), (BothLink { length: 0.1 }, [link; 3]));
}

#[test]
fn names_of_the_mechanism_do_not_change_what_a_component_means() {
    let apart = Apart::default();
    let end = apart.end(&apart.solve(0.5).expect("drives turn everything")).value;
    let exact = polar(0.1, 0.5);
    assert!((end.x - exact[0] - 6.0).abs() < 1e-15 && (end.y - exact[1] - 2.0).abs() < 1e-15, "{end:?}");
}

#[test]
fn components_of_one_name_in_two_bundles_have_the_constraints_of_their_own() {
    let state = Two::default().solve(0.0).expect("all is fixed");
    assert_eq!((state.pile().top().position.y, state.drop().top().position.y), (0.03, -0.04));
}

#[test]
fn a_bundle_gives_what_is_for_the_ambient() {
    let place = Slide::default().solve(0.25).expect("it is driven").slide().position;
    assert_eq!((place.x, place.y, place.z), (0.25, 1.0, 2.0));
}

#[test]
fn a_component_of_a_bundle_has_the_constraints_of_the_bundle() {
    let piles = Piles::default();
    let top = piles.top(&piles.solve(0.0).expect("all is fixed")).value;
    assert!(top.x == 0.0 && (top.y - 0.07).abs() < 1e-17);
}

#[test]
fn masses_and_freedoms_come_with_a_component() {
    let mut pendulums = Pendulums::default();
    pendulums.left[1].length = 0.25;
    let state = pendulums.initial_state().expect("it is released");
    for (pendulum, length) in state.left().iter().zip([0.5, 0.25]) {
        let exact = -9.81 / length * 30_f64.to_radians().sin();
        assert!((pendulum.bob().angular_acceleration - exact).abs() < 1e-14 * exact.abs());
    }
}

#[test]
fn a_component_in_space_turns_about_the_axis_it_is_given() {
    let turned = Turned::default();
    for step in 0..10 {
        let t = f64::from(step) / 3.0;
        let end = turned.end(&turned.solve(t).expect("it turns")).value;
        let exact = [1.0 + 0.05, 2.0 + 0.1 * t.cos(), 3.0 + 0.1 * t.sin()];
        assert!((0..3).all(|k| (end[k] - exact[k]).abs() < 2e-15), "at {t}: {end:?} is not {exact:?}");
    }
}
