use crate::expr::{Arena, Exact, Expr};

fn decimal(arena: &mut Arena, digits: i128, places: u32) -> Expr {
    let value = Exact::ratio(digits, 10_i128.pow(places)).expect("it fits");
    arena.constant(value)
}

#[test]
fn functions_of_constants_are_right_to_thirty_digits() {
    let mut arena = Arena::new();
    let (one, five, two) = (arena.integer(1), arena.integer(5), arena.integer(2));
    let found = [arena.sin(one), arena.cos(one), arena.sin(five), arena.cos(five), arena.sqrt(two)];
    // From tables.
    let wanted = [
        841_470_984_807_896_506_652_502_321_630,
        540_302_305_868_139_717_400_936_607_443,
        -958_924_274_663_138_468_893_154_406_156,
        283_662_185_463_226_264_466_639_171_514,
        1_414_213_562_373_095_048_801_688_724_210,
    ];
    for (found, digits) in found.into_iter().zip(wanted) {
        let wanted = decimal(&mut arena, digits, 30);
        let difference = arena.sub(found, wanted);
        let rest = arena.snapped(difference);
        assert_eq!(rest, arena.integer(0), "{digits}");
        // A difference in the 25th digit is none of rounding.
        let other = decimal(&mut arena, digits + 100_000, 30);
        let difference = arena.sub(found, other);
        let rest = arena.snapped(difference);
        assert_ne!(rest, arena.integer(0), "{digits}");
    }
}

#[test]
fn constants_are_rounded_once() {
    let mut arena = Arena::new();
    let angle = decimal(&mut arena, 3, 1);
    let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
    // (cos 0.3, sin 0.3), turned sixteen times by 0.3 rad.
    let mut vector = [cosine, sine];
    for _ in 0..16 {
        let [x, y] = vector;
        let products = [(x, cosine), (y, sine), (x, sine), (y, cosine)].map(|(part, factor)| arena.mul(part, factor));
        vector = [arena.sub(products[0], products[1]), arena.add(products[2], products[3])];
    }
    let values = vector.map(|part| arena.value(part).expect("a constant"));
    // cos 5.1 and sin 5.1 from tables.
    assert_eq!(values, [0.377_977_742_712_980_56, -0.925_814_682_327_732_3]);
}

#[test]
fn constants_that_cancel_have_the_value_zero() {
    let mut arena = Arena::new();
    let angle = decimal(&mut arena, 7, 1);
    let (sine, cosine, one) = (arena.sin(angle), arena.cos(angle), arena.integer(1));
    let squares = [sine, cosine].map(|part| arena.square(part));
    let sum = arena.sum(&squares);
    let rest = arena.sub(sum, one);
    assert_eq!(arena.value(rest), Some(0.0));
}

#[test]
fn what_cancels_is_zero() {
    let mut arena = Arena::new();
    let angle = decimal(&mut arena, 3, 1);
    let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
    let squares = [sine, cosine].map(|part| arena.square(part));
    let sum = arena.sum(&squares);
    assert_eq!(arena.snapped(sum), arena.integer(1));
}
