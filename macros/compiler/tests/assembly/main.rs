//! Assembly at the declared defaults: mechanisms that close, and the gaps of those that do not, compared with plane geometry.

mod accepted;
mod cams;
mod gaps;
mod gears;
mod joints;
mod nearest;
mod orientations;
mod plates;
mod range;
#[path = "../../src/expr/tests/samples.rs"]
mod samples;
mod starts;
mod turned;

use reuleaux_compiler::Compiled;
use reuleaux_compiler::diag::Fact;
use samples::samples;

/// Compiles a mechanism that must be accepted.
fn accepted(source: &str) -> Compiled {
    let compiled = reuleaux_compiler::compile(source.parse().expect("tokens"));
    compiled.unwrap_or_else(|refusals| panic!("{}\nin {source}", refusals[0].fact))
}

/// The single fact for which a mechanism is refused.
fn refused(source: &str) -> Fact {
    let refusals = reuleaux_compiler::compile(source.parse().expect("tokens")).err().unwrap_or_else(|| panic!("accepted: {source}"));
    assert_eq!(refusals.len(), 1, "{source}");
    refusals[0].fact.clone()
}

/// The value of a coordinate at the start.
fn start(compiled: &Compiled, name: &str) -> f64 {
    let (system, model) = (&compiled.system, &compiled.model);
    let is_wanted =
        |unknown: &reuleaux_compiler::system::Coordinate| format!("{}.{}", model.bodies[unknown.body].name, unknown.role.name()) == name;
    compiled.assembly.start[system.coordinates.iter().position(is_wanted).expect(name)]
}

/// A four-bar with pivots at (0, 0) and (ground, 0), in mm and degrees.
fn four_bar([ground, crank, coupler, rocker]: [f64; 4], angle: f64, starts: &str) -> String {
    format!(
        "mechanism FourBar {{ ground {{ point C = ({ground}mm, 0mm); }} body crank {{ point A = ({crank}mm, 0mm); }}
            body coupler {{ point B = ({coupler}mm, 0mm); }} body rocker {{ point B = ({rocker}mm, 0mm); {starts} }}
            joint o = revolute(ground.position, crank.position); joint a = revolute(crank.A, coupler.position);
            joint b = revolute(coupler.B, rocker.B); joint c = revolute(rocker.position, ground.C);
            drive input = drive_angle(crank, ({angle}) * 1deg + 1rad_s * t); }}"
    )
}

/// A four-bar in space with pivots at (0, 0, 0) and (400, 0, 0) mm and parallel hinges; the crank is at an angle in degrees.
fn spatial_four_bar(angle: f64, rocker: &str, starts: &str) -> String {
    format!(
        "mechanism FourBar in space {{
            ground {{ axis z = (0, 0, 1); point C = (400mm, 0mm, 0mm); }}
            body crank {{ axis z = (0, 0, 1); point A = (100mm, 0mm, 0mm); }}
            body coupler {{ axis z = (0, 0, 1); point B = (350mm, 0mm, 0mm); }}
            body rocker {{ axis z = (0, 0, 1); point B = (300mm, 0mm, 0mm); {rocker} }}
            joint o = revolute(ground.position, ground.z, crank.position, crank.z);
            joint a = spherical(crank.A, coupler.position);
            joint b = cylindrical(coupler.B, coupler.z, rocker.B, rocker.z);
            joint c = revolute(ground.C, ground.z, rocker.position, rocker.z);
            {starts}
            drive input = drive_rotation(o, {angle}deg + 60rpm * t); }}"
    )
}

/// Marsaglia's xorshift.
struct Random(u64);

impl Random {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        // Three decimals, so that the declared number is exact.
        let share = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        ((from + (to - from) * share) * 1e3).round() / 1e3
    }
}
