//! The procedural macros of reuleaux, and the reference of its language.
//!
//! Users depend on the crate `reuleaux`, which re-exports both macros: [`mechanism!`] declares a mechanism and becomes a type that
//! can be solved, [`constraint!`] defines a kind of joint that mechanisms can use. The joints, drives and motion laws that are
//! always there are the modules of `reuleaux::library`, one manual page each.
//!
//! This crate is only doors: the compiler behind them is the ordinary library `reuleaux-compiler`.

use proc_macro::TokenStream;

/// Declares a mechanism: bodies, joints and drives in, a type with functions that solve it out.
///
/// ```
/// use reuleaux::mechanism;
///
/// mechanism! {
///     /// A crank pushes a slider to and fro.
///     pub mechanism SliderCrank {
///         /// From the axle to the pin.
///         param radius: Length = 30mm;
///         param rod_length: Length = 100mm;
///         param speed: AngularVelocity = 60rpm;
///
///         ground { point O = (0mm, 0mm);  axis u = (1, 0); }
///         body crank  { point O = (0mm, 0mm);  point A = (radius, 0mm); }
///         body rod    { point A = (0mm, 0mm);  point B = (rod_length, 0mm); }
///         body slider { point B = (0mm, 0mm);  start position = (130mm, 0mm); }
///
///         joint axle = revolute(ground.O, crank.O);
///         joint pin = revolute(crank.A, rod.A);
///         joint wrist = revolute(rod.B, slider.B);
///         joint guide = translational(ground.u, ground.O, slider.B);
///         drive motor = drive_angle(crank, speed * t);
///
///         output stroke = slider.x;
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mechanism = SliderCrank { radius: 0.04, ..Default::default() };
/// let state = mechanism.solve(0.5)?;                       // half a turn at 60 rpm
/// let stroke = mechanism.stroke(&state);                   // value, rate, acceleration
/// assert!((stroke.value - 0.06).abs() < 1e-15);
/// assert!((state.rod().angular_velocity - 0.8 * std::f64::consts::PI).abs() < 1e-14);
/// # Ok(())
/// # }
/// ```
///
/// # Items
///
/// One `mechanism!` declares one mechanism. Its items may stand in any order; a name may be used before it is declared.
///
/// ```text
/// mechanism  = doc* ["#[equations_only]"] [visibility] "mechanism" Name "{" item* "}"
/// item       = "use" path ";"  |  "use" path "::" "{" path ["as" name], … "}" ";"
///            | doc* "param" array ":" dimension "=" expression ";"
///            | "let" array [":" dimension] "=" expression ";"
///            | "function" name "(" name ":" dimension ")" "->" dimension "=" expression ";"
///            | "function" name "(" dimension ")" "->" dimension "=" rust-path ";"
///            | "ground" "{" mark* "}"
///            | doc* "body" array "{" (mark | start)* "}"
///            | doc* ("joint" | "drive") array "=" constraint "(" argument, … ")" ";"
///            | doc* ("joint" | "drive") array "=" "{" statement* "}"
///            | doc* "output" array "=" expression ";"
///            | doc* "component" Name "(" parameter, … ")" "{" item* "}"
///            | doc* "part" array "=" Name "(" argument, … ")" ";"
///            | "for" name "in" range "{" item* "}"
/// mark       = ("point" | "axis") array "=" "(" expression "," expression ")" ";"
///            | "for" name "in" range "{" mark* "}"
/// array      = name ("[" expression "]")*
/// range      = expression (".." | "..=") expression
/// start      = "start" ("x" | "y" | "position" | "angle") "=" expression ";"
/// argument   = [name ":"] expression
/// statement  = "let" name [":" dimension] "=" expression ";"
///            | expression "==" expression ";"
///            | "require" expression relation expression ":" "why" ";"
/// dimension  = Name ["^" digit] (("*" | "/") Name ["^" digit])*
/// relation   = "<" | "<=" | ">" | ">=" | "==" | "!="
/// ```
///
/// Parameters, `let`s, functions, bodies, joints, drives and parts share one set of names, in which `t`, `pi`, `ground` and the built-in
/// functions are taken. Points and axes belong to their body, outputs are a set of their own.
///
/// ## `param`
///
/// A public field of the generated type, with a default. The default is a constant; what follows from other quantities is a `let`.
/// In the declaration a parameter carries its unit, in Rust it is a number in SI.
///
/// ## `let`
///
/// A name for an expression: a number, a vector, a point, an axis. It may depend on parameters, on `t` and on what moves. Without
/// a dimension it measures what its value measures, and a bare number is a pure number.
///
/// ## `ground` and `body`
///
/// A `point` is a place and an `axis` a direction in the frame of its body, with two coordinates that may depend on parameters.
/// An axis need not have unit length; the library divides by it where it matters. Every body has the coordinates x and y, the
/// place of its frame's origin in ground (m), and φ, its angle (rad, to the left, never wrapped). Ground has none.
///
/// `start` says where a body is at t = 0. What is not said follows from the joints: the compiler assembles the mechanism at the
/// declared defaults, as near to what was said as it can. One angle is usually enough to tell an assembly from its mirror image.
/// A body of which nothing is said is looked for from the origin; a follower on a cam needs a `start`, since from the cam's centre
/// no direction leads out.
///
/// ## `joint` and `drive`
///
/// A constraint with its arguments, in order or by name, or equations written inline. Only a drive may contain `t`. An equation of
/// vectors is two rows.
///
/// ```
/// # reuleaux::mechanism! {
/// #     /// A turning arm whose end slides on a parabola-shaped law.
/// #     pub mechanism Inline {
/// body arm { point O = (0mm, 0mm);  point P = (200mm, 0mm); }
/// body bead { start position = (100mm, 0mm); }
///
/// joint axle = revolute(ground.position, Q: arm.O);
/// joint bead_on_arm = {
///     let u = unit(arm.P - arm.O);
///     cross(u, bead.position - arm.O) == 0;
///     bead.angle == arm.angle;
/// }
/// drive motor = drive_angle(arm, 1rad_s * t);
/// drive push = { norm(bead.position - arm.O) == 100mm + 20mm * sin(2rad_s * t); }
/// #     }
/// # }
/// # Inline::default().solve(1.0).unwrap();
/// ```
///
/// Inside expressions a joint's name gives its arguments back: `guide.u`, `guide.P`, `guide.Q` for the slider-crank above. A
/// constraint that takes a joint, such as `drive_along(guide, 30mm * sin(speed * t))`, is built on that.
///
/// ## `output`
///
/// A number, a vector or a point, generated as a method that gives it with its first and second derivative in time; or a whole
/// body, given as its accessor gives it.
///
/// ## `for` and arrays
///
/// A loop repeats items. Its variable is a whole number and may stand in any expression; every name declared in a loop carries an
/// index for it, as in `body link[i]`. Indices and ranges are made of whole numbers, `let`s of them and loop variables with +,
/// −, *, / and %, the remainder, which is never negative; a quotient must be whole. Loops nest, and names have as many indices as
/// they need. An array can also be declared member by member. Bodies, parameters, outputs and parts become arrays in Rust, whose
/// indices run from 0 without gaps; joints, points and `let`s need not begin at 0.
///
/// ```
/// reuleaux::mechanism! {
///     /// A chain of four-bars: each crank drives the next.
///     pub mechanism Chain {
///         param length[0]: Length = 50mm;
///         for i in 1..=3 { param length[i]: Length = 50mm + i * 1mm; }
///         let bars = 3;
///
///         ground { for i in 0..=bars { point P[i] = (i * 100mm, 0mm); } }
///         for i in 0..=bars { body crank[i] { point A = (length[i], 0mm);  start angle = 80deg; } }
///         for i in 0..bars { body coupler[i] { point B = (100mm, 0mm); } }
///
///         for i in 0..=bars { joint axle[i] = revolute(ground.P[i], crank[i].position); }
///         for i in 0..bars {
///             joint a[i] = revolute(crank[i].A, coupler[i].position);
///             joint b[i] = revolute(coupler[i].B, crank[i + 1].A);
///         }
///         drive motor = drive_angle(crank[0], 80deg + 20deg * sin(1rad_s * t));
///         for i in 0..=bars { output tip[i] = crank[i].A; }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut chain = Chain::default();
/// chain.length = [0.05; 4];                               // now it is made of parallelograms
/// let state = chain.solve(1.0)?;
/// let [first, .., last] = state.crank();
/// assert!((first.angle - last.angle).abs() < 1e-14);
/// assert_eq!(chain.tip(&state).len(), 4);
/// # Ok(())
/// # }
/// ```
///
/// ## `component` and `part`
///
/// A component is declared once and used as often as there are parts of it. It takes what a constraint takes (see
/// [`constraint!`]); its items are parameters, `let`s, bodies, joints, drives, outputs, loops and parts of other components. Beside
/// its arguments and its own items it sees the parameters, `let`s, functions, ground and components of the mechanism, but no
/// body of it: a body comes in as an argument. From outside a part's items, arguments among them, are `part.name`.
///
/// ```
/// reuleaux::mechanism! {
///     /// A folding rule: each arm turns on the end of the one before.
///     pub mechanism Rule {
///         let arms = 4;
///         part arm[0] = Arm(ground.position, 10deg);
///         for i in 1..arms { part arm[i] = Arm(arm[i - 1].limb.end, 10deg * (i + 1)); }
///
///         component Arm(hinge: Point, angle: Angle) {
///             param length: Length = 250mm;
///             body limb { point end = (length, 0mm); }
///             joint pin = revolute(hinge, limb.position);
///             drive fold = drive_angle(limb, angle * (t / 1s));
///             output end = limb.end;
///         }
///         output end = arm[arms - 1].limb.end;
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut rule = Rule::default();
/// rule.arm[3].length = 0.125;
/// assert_eq!(rule.arm[0], RuleArm { length: 0.25 });
/// let state = rule.solve(0.0)?;
/// assert_eq!(rule.end(&state).value.x, 0.875);
/// assert_eq!(rule.arm_end(&state).map(|end| end.value.x), [0.25, 0.5, 0.75, 0.875]);
/// for arm in state.arm() {
///     assert_eq!(arm.limb().angle, 0.0);
/// }
/// # Ok(())
/// # }
/// ```
///
/// All parts of a component have the same bodies, parameters, outputs and parts; numbers and joints may differ. In q the bodies of a
/// part stand next to each other, where the part stands; in messages and in `COORDINATES` and `ROWS` they are called
/// `arm[3].limb`.
///
/// ## `use`
///
/// Brings in constraints defined by [`constraint!`], in this crate or another, by the path at which Rust finds them. A bundle
/// brings in all its constraints under their own names; one of them alone is `use path::bundle::constraint;`. The library needs no
/// `use`.
///
/// ## `#[equations_only]`
///
/// Gives Φ, Φ_q, ν and γ of a system that need not have as many equations as coordinates, and no way to solve it.
///
/// ```
/// reuleaux::mechanism! {
///     #[equations_only]
///     pub mechanism DoublePendulum {
///         body one { point A = (0m, 0m);  point B = (1m, 0m); }
///         body two { point B = (0m, 0m); }
///         joint a = revolute(ground.position, one.A);
///         joint b = revolute(one.B, two.B);
///     }
/// }
/// assert_eq!((DoublePendulum::<f64>::COORDINATES, DoublePendulum::<f64>::EQUATIONS), (6, 4));
/// ```
///
/// # Expressions
///
/// From loose to tight:
///
/// ```text
/// a + b   a − b            sums, of numbers or of vectors
/// a * b   a / b   a % b    products; a vector times or by a number; a remainder
/// −a
/// a ^ b                    power, from the right: a^b^c = a^(b^c), −a^2 = −(a^2), a^−b = a^(−b)
/// a.name   a[i]            a part of a, a member of it
/// ```
///
/// | | |
/// | --- | --- |
/// | `1.5`, `120mm`, `1e-3s` | a number, with its unit right behind it; kept exactly until code is emitted |
/// | `pi`, `t` | π; time in s |
/// | `(x, y)` | a vector in ground |
/// | `body.angle`, `body.x`, `body.y` | the coordinates of a body |
/// | `body.position`, `body.P`, `body.u` | its origin, and the points and axes declared in it |
/// | `P.x`, `P.y`, `P.body` | the place of a point, a vector's or an axis's components in ground; the body it belongs to |
/// | `joint.argument` | what a joint was made with |
/// | `sin` `cos` `tan` | of an angle or a pure number |
/// | `asin` `acos` `atan` `atan2(y, x)` | an angle |
/// | `sqrt` `exp` `ln` `abs` `min(a, b)` `max(a, b)` | |
/// | `dot(a, b)`, `cross(a, b)` | a_x b_x + a_y b_y and a_x b_y − a_y b_x |
/// | `perp(a)` | a turned to the left by a right angle, (−a_y, a_x) |
/// | `norm(a)`, `unit(a)` | the length of a, a divided by it |
/// | `direction(a)` | the angle of a against the x axis of ground, from −π to π |
/// | `body[i]`, `body[i].P[j]`, `part[i].body`, `part[i].joint` | members of arrays, what a part has |
/// | `i % n` | the remainder of whole numbers that are known to the compiler |
/// | `if a < b { x } else { y }` | a number that depends on a comparison with `<`, `<=`, `>` or `>=`; `else if` may follow |
/// | `table(x, [(x0, y0), …], ends)` | a spline through measured points |
/// | `f(x)`, `path::to::f(x)` | a function declared here, one of the library, a Rust function |
///
/// Where a vector is wanted a point stands for its place and an axis for its direction. Where a constraint wants a point or an axis,
/// a constant vector is one of ground: `absolute_distance(rod.B, (0mm, 0mm), 80mm)`.
///
/// A whole power is a product, a half one a square root, any other an exponential. An `if` is differentiated branch by branch:
/// whether the branches meet is for you to see to.
///
/// # Dimensions
///
/// Every quantity is a product of powers of length, angle, time and mass, and mistakes are refused. The names are
///
/// ```text
/// Number  Length  Angle  Time  Mass  Area  Velocity  Acceleration  AngularVelocity  AngularAcceleration
/// Frequency  Force  Torque  Inertia  Stiffness
/// ```
///
/// and what is made of them: `Length / Time^2`, `Mass * Length^2`.
///
/// - A bare number takes the dimension that its place asks for, in SI: `param r: Length = 0.12;` is 120 mm.
/// - A sum, a comparison and an equation have the same dimension on both sides.
/// - Angle is a dimension of its own against a length, a time or a mass, and counts for nothing beside them: radius times angle is
///   a length, `length * AngularVelocity` a velocity. A ratio of lengths may stand for an angle, an angle for a pure number only
///   as the argument of `sin`, `exp` and the like. For the number of radians write `a / 1rad`.
/// - A quantity is raised only to a power that is written out, a multiple of 1/6; `sqrt` halves the exponents.
///
/// # Units
///
/// | | |
/// | --- | --- |
/// | length | `m` `cm` `mm` `um` `km` `in` `ft` |
/// | angle | `rad` `mrad` `deg` `turn` |
/// | time | `s` `ms` `us` `min` `h` |
/// | mass | `kg` `g` |
/// | angular velocity | `rad_s` `deg_s` `rpm` |
/// | angular acceleration | `rad_s2` `deg_s2` |
/// | velocity, acceleration | `m_s` `mm_s`, `m_s2` `mm_s2` |
/// | area | `m2` `mm2` |
/// | force, torque, inertia | `N` `kN`, `Nm`, `kgm2` |
///
/// All are exact, `deg` and `rpm` by way of an exact π; other units are quotients, such as `3kN / 1mm` for a stiffness.
///
/// ```
/// reuleaux::mechanism! {
///     #[equations_only]
///     pub mechanism Units {
///         param length: Length = 1m + 1cm + 1mm + 1um + 1km + 1in + 1ft;
///         param angle: Angle = 1rad + 1mrad + 1deg + 1turn;
///         param time: Time = 1s + 1ms + 1us + 1min + 1h;
///         param mass: Mass = 1kg + 1g;
///         param turning: AngularVelocity = 1rad_s + 1deg_s + 1rpm;
///         param speeding_up: AngularAcceleration = 1rad_s2 + 1deg_s2;
///         param velocity: Velocity = 1m_s + 1mm_s;
///         param acceleration: Acceleration = 1m_s2 + 1mm_s2;
///         param area: Area = 1m2 + 1mm2;
///         param force: Force = 1N + 1kN;
///         param torque: Torque = 1Nm;
///         param inertia: Inertia = 1kgm2;
///         param stiffness: Stiffness = 3kN / 1mm;
///         param power: Mass * Length^2 / Time^3 = 750;
///         param arc: Length = 30mm * 20deg;
///         param incline: Angle = 1mm / 20mm;
///         param radians: Number = 20deg / 1rad;
///         body b { }
///         joint j = { b.position == (0, 0); }
///     }
/// }
/// let units = Units::default();
/// assert_eq!((units.time, units.velocity, units.stiffness), (3661.001001, 1.001, 3e6));
/// ```
///
/// # Functions of one variable
///
/// **Motion laws** of the library rise from 0 to 1 while their argument does: `harmonic`, `cycloidal`, `polynomial_345`,
/// `polynomial_4567`, `modified_trapezoidal`, `smooth_step`. Give them time over duration and multiply by the rise. Over an angle that
/// goes on turning, such as a cam's, take `wrap(angle)`, which is the same angle between −π and π.
///
/// **Written here**, a function has one argument and an expression; it sees the parameters and the other functions.
///
/// **Tables** are cubic splines with a continuous second derivative through constants whose first numbers increase. Outside them a
/// table is `periodic` (first and last value agree), `linear` (goes on along the tangent; what it is if nothing is said) or `hold`
/// (keeps the last value, and arrives there with slope zero).
///
/// **Rust functions** are named by their path, and give value, first and second derivative over any number type:
/// `fn<T: Real>(T) -> (T, T, T)`, in SI. The compiler does not run them, so that the start is found by the runtime instead. A
/// `function` item without an argument's name says what such a function takes and gives; called by its path it takes and gives what
/// its place asks for. A law that exists for `f64` only is lifted by `Real::map`.
///
/// ```
/// use reuleaux::Real;
///
/// /// Lift of a cam (m) over its angle (rad), with first and second derivative.
/// pub fn measured<T: Real>(angle: T) -> (T, T, T) {
///     let (sin, cos) = angle.sin_cos();
///     (T::of(0.005) * (T::of(1.0) - cos), T::of(0.005) * sin, T::of(0.005) * cos)
/// }
///
/// reuleaux::mechanism! {
///     /// Four ways to write a law.
///     pub mechanism Laws {
///         param base: Length = 40mm;
///         param speed: AngularVelocity = 60rpm;
///
///         function outline(Angle) -> Length = measured;
///         function eccentric(psi: Angle) -> Length = base + 5mm * cos(psi);
///         let lift = table(speed * t, [(0deg, 0mm), (120deg, 12mm), (240deg, 12mm), (360deg, 0mm)], periodic);
///
///         body cam { }
///         body knife { start y = 45mm; }
///         body rising { }
///         joint axle = revolute(ground.position, cam.position);
///         joint guide = translational((0, 1), (0mm, 0mm), knife.position);
///         joint contact = cam_knife(cam.position, knife.position, eccentric);
///         drive motor = drive_angle(cam, speed * t);
///
///         joint upright = absolute_angle(rising, 0deg);
///         joint rail = absolute_x(rising.position, 100mm);
///         drive table_law = drive_y(rising.position, lift + 20mm * cycloidal((t - 1s) / 0.5s) + outline(speed * t));
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let knife = Laws::default().solve(0.25)?.knife();
/// assert!((knife.position.y - 0.045).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
///
/// # What is generated
///
/// For a mechanism `Name` with N coordinates and M equations, over any number type `T: Real` and `f64` unless said:
///
/// | | shape | unit |
/// | --- | --- | --- |
/// | `struct Name<T = f64>` with the parameters as public fields | | SI |
/// | `Name::default()`, `Name::<T>::with_defaults()` | | |
/// | `COORDINATES`, `EQUATIONS`, `JACOBIAN_ENTRIES`: N, M, number of entries of Φ_q that can differ from zero | | |
/// | `phi(&q, t)`: Φ | M | of each row |
/// | `jacobian(&q, t)`: Φ_q | M × N | of the row per m or rad |
/// | `jacobian_entries(&q, t)`, in the order of `JACOBIAN_PATTERN` | `JACOBIAN_ENTRIES` | the same |
/// | `linearize(&q, t)`: Φ and Φ_q together | M, M × N | |
/// | `nu(&q, t)`: ν | M | of each row per s |
/// | `gamma(&q, &qd, t)`: γ | M | of each row per s² |
/// | `start()`: the assembled configuration at t = 0 | N | m, rad |
/// | `characteristic_length()`: what is worth a radian when lengths and angles are compared | 1 | m |
/// | `validate()`: whether the parameters are finite and meet every `require` | | |
/// | an output's name`(&state)`: `Motion { value, rate, acceleration }` of `T` or `Vector2<T>`, or `PlanarBody` | 1 or 2 | SI |
///
/// and unless it is `#[equations_only]`, for `T: Float`, which is `f64` and `f32`:
///
/// | | |
/// | --- | --- |
/// | `PLAN` | which coordinates are computed and which iterated, in which order, with operation counts |
/// | `solve(t)` | the state at time t (s), followed from the start |
/// | `solve_near(t, &q)` | the state that Newton's method finds from a guess, of whatever assembly |
/// | `solve_from(t, &state)` | the state at t on the branch of another one |
/// | `advance(&mut state, t)` | the same in place |
/// | `sweep(times)` | an iterator over states, each followed from the one before |
/// | `prepared()` | the mechanism with everything computed that depends on its parameters only, for loops with `advance`
/// | `solve_for_tip()` for an output `tip` | `NameForTip`: only what is upstream of it, with `solve`, `solve_from`, `advance`, `sweep` and a `PLAN` of its own; its states, `NameStateForTip`, give the output by its name, `state.tip()`
/// | `struct NameState<T = f64>` | t, q, q̇, q̈ and more by `Deref` to `reuleaux::State` |
/// | a body's name`()` on the state | `PlanarBody`: position, angle, velocities, accelerations, and the motion of any `point` of it |
///
/// With the environment variable `REULEAUX_EXPAND` set to a folder, the code of each mechanism that is compiled is written there as
/// `Name.rs`, formatted if there is rustfmt.
///
/// With components and arrays:
///
/// | | |
/// | --- | --- |
/// | `struct NameLeg<T = f64>` | the parameters of a component `Leg`, if it has any; those of its parts are fields of it |
/// | the field `leg: [NameLeg<T>; 6]` | the parameters of its parts; `leg: NameLeg<T>` for a single one |
/// | `NameLeg::default()` | if the defaults are the same for all its parts |
/// | `state.leg()[3]` | a view of a part, `NameStateLeg`, with its bodies and parts by their names |
/// | `state.link()` | an array of bodies, `[PlanarBody<T>; n]` |
/// | `mechanism.leg_foot(&state)` | the output `foot` of all parts `leg`, `[Motion; 6]` |
///
/// An index that is out of range in Rust is refused by rustc where it is a constant.
///
/// The order of q is that of the bodies, x, y and φ of each; the order of Φ is that of the joints and drives. The traits
/// `reuleaux::Equations` and `reuleaux::Mechanism` are implemented, so that generic code can take any mechanism. Doc comments reach
/// the generated items, and the type's page has tables of its parameters, coordinates and equations.
///
/// # Errors
///
/// A mistake in the declaration is a compile error under the word that is to blame. All are reported at once, and the type is
/// still there, without content, so that the rest of the program gives no errors of its own.
///
/// ```compile_fail
/// reuleaux::mechanism! {
///     pub mechanism Wheel {
///         body wheel { point O = (0mm, 0mm); }
///         joint axle = revolute(ground.position, wheel);      // `Q` of `revolute` takes a point, found a body
///         drive motor = drive_angle(wheel, 60rpm);            // `C` of `drive_angle` is an angle (rad), found an angular velocity (rad/s)
///     }
/// }
/// ```
///
/// What shows only at run time is a `reuleaux::Failure`: it does not close, it stands at a dead point, the branch ends, a parameter
/// or a number is out of range. It names the joint, the coordinate and the time, and carries the last valid state.
///
/// # Limits
///
/// Names of mechanisms, parameters, bodies and outputs are Rust identifiers and no keywords. Parentheses nest up to 50 deep, a sum
/// has up to 200 terms, a loop 10,000 rounds, a mechanism up to 100,000 items and 200,000 operations, a number up to 36 digits between 1e-36 and 1e36. Beyond 240
/// coordinates the compiler takes the start as it is declared and does not assemble it.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::mechanism(tokens.into()).into()
}

/// Defines constraints: kinds of joints and drives that mechanisms can use, in this crate and in others.
///
/// ```
/// reuleaux::constraint! {
///     /// A wheel rolls without slipping along a straight line through `P` along `u`, `c` along it when upright.
///     ///
///     /// ```text
///     ///   û⊥ · (r_Q − r_P) − R         = 0        row 1, m
///     ///   û  · (r_Q − r_P) + R φ − c   = 0        row 2, m
///     /// ```
///     pub constraint rolling(wheel: Body, P: Point, u: Axis, R: Length, c: Length = 0) {
///         require R > 0: "a wheel without radius cannot roll";
///         require wheel != P.body: "a wheel rolls on another body";
///         let way = wheel.position - P;
///         dot(perp(unit(u)), way) == R;
///         dot(unit(u), way) + R * (wheel.angle - P.body.angle) == c;
///     }
/// }
///
/// reuleaux::mechanism! {
///     pub mechanism Wheel {
///         use crate::rolling;
///         param radius: Length = 300mm;
///         body wheel { point rim = (radius, 0mm); }
///         joint road = rolling(wheel, ground.position, (1, 0), R: radius);
///         drive speed = drive_x(wheel.position, 2m_s * t);
///         output cycloid = wheel.rim;
///     }
/// }
///
/// fn main() -> Result<(), Box<dyn std::error::Error>> {
///     let wheel = Wheel { radius: 0.25, ..Default::default() };
///     assert_eq!(wheel.solve(1.0)?.wheel().angular_velocity, -8.0);
///     Ok(())
/// }
/// ```
///
/// # Definitions
///
/// ```text
/// constraint!  { (constraint | bundle)* }
/// constraint = doc* [visibility] "constraint" name "(" parameter, … ")" "{" statement* "}"
/// bundle     = doc* [visibility] "bundle" name "{" constraint* "}"
/// parameter  = name ":" kind ["=" expression]
/// kind       = "Point" | "Axis" | "Body" | "Quantity" | dimension
///            | "Function" "(" dimension ")" "->" dimension | "Joint" "(" constraint ")"
/// ```
///
/// Statements, expressions and dimensions are those of [`mechanism!`].
///
/// # Parameters
///
/// | kind | takes | in the definition |
/// | --- | --- | --- |
/// | `Point` | a point of a body or of ground, or a constant vector | a vector; `P.body` is what it belongs to |
/// | `Axis` | an axis of a body or of ground, or a constant vector | a vector that turns with `u.body` |
/// | `Body` | a body or ground | `b.angle`, `b.position`, `b.x`, `b.y` |
/// | `Length`, `Angle`, … | a number of this dimension; of a drive it may depend on `t` | the number |
/// | `Quantity` | a number of any dimension | the number, as it is measured where it is used |
/// | `Function(Angle) -> Length` | a function of one variable: declared, of the library or a Rust path | `f(x)` |
/// | `Joint(translational)` | a joint of this kind, by its name | `j.u`, `j.P`: its arguments |
///
/// A parameter with a default may be left out; the default sees the parameters before it. `ground` is known in a definition, `t`
/// is not: a law of time is a parameter, to which a `drive` passes an expression of `t`.
///
/// # Statements
///
/// Equations become rows in the order written, an equation of vectors two of them. The residual is the left minus the right side;
/// write it in metres or radians where you can, and do not square what need not be squared. Everything else, Φ_q, ν and γ, is derived.
///
/// `require` is a condition for the equations to make sense. One on bodies (`P.body != Q.body`) is decided when the joint is
/// declared. One on numbers is refused at compile time if it fails at the declared defaults, and is asked again by `validate`
/// whenever the mechanism is solved; one on a law of time is not checked.
///
/// A definition is checked where it stands, for arguments of which nothing but their kind is known: names, dimensions, and that
/// every row depends on the position of a body.
///
/// # How definitions travel
///
/// A `pub` constraint is exported from its crate like a macro, and found by the path at which it is defined:
///
/// ```text
/// use my_joints::wheels::rolling;
/// use my_joints::wheels::{rolling as rolls, slipping};
/// ```
///
/// Each one used costs two of the 128 levels of the recursion limit of the crate that uses it. Many that belong together go as one
/// bundle, which costs as much as one:
///
/// ```
/// reuleaux::constraint! {
///     /// Joints to places in ground.
///     pub bundle places {
///         /// A point stays on a horizontal line.
///         constraint at_height(P: Point, h: Length) { P.y == h; }
///         /// A point stays on a vertical line.
///         constraint at_distance(P: Point, d: Length) { P.x == d; }
///     }
/// }
///
/// reuleaux::mechanism! {
///     pub mechanism Ladder {
///         use crate::places;
///         param speed: Velocity = 100mm_s;
///         body ladder { point foot = (0m, 0m);  point top = (0m, 5m);  start angle = 20deg; }
///         joint wall = at_distance(ladder.top, 0m);
///         joint floor = at_height(ladder.foot, 0m);
///         drive slip = drive_x(ladder.foot, 2m + speed * t);
///     }
/// }
///
/// fn main() -> Result<(), Box<dyn std::error::Error>> {
///     let ladder = Ladder::default().solve(10.0)?.ladder();       // 3 : 4 : 5
///     assert!((ladder.angular_velocity - 0.1 / 4.0).abs() < 1e-15);
///     Ok(())
/// }
/// ```
#[proc_macro]
pub fn constraint(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::constraint(tokens.into()).into()
}

/// Goes on with a mechanism after a definition has been handed over.
#[doc(hidden)]
#[proc_macro]
pub fn __resume(tokens: TokenStream) -> TokenStream {
    reuleaux_compiler::resume(tokens.into()).into()
}

/// The manual pages of the standard library, as modules.
#[doc(hidden)]
#[proc_macro]
pub fn __library_pages(_: TokenStream) -> TokenStream {
    reuleaux_compiler::library_pages().into()
}

/// The Rust blocks of the README are compiled and run with those of the pages above.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
