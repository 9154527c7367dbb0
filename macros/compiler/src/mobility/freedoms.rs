//! Remaining freedoms: undetermined coordinates and missing drives.

use crate::diag::{Count, Diag, Forgotten, SystemFact};
use crate::model::{Model, Relationship, example};
use crate::quantity::{Ambient, Axis, Role};
use crate::structure::{DmPart, Entry, Matching, Pattern, maximum};
use crate::system::System;
use std::collections::{BTreeMap, BTreeSet};

/// Largest number of missing drives that are suggested.
const MOST_CHOSEN: usize = 4;

/// Largest number of bodies tested for a forgotten joint.
const MOST_TRIED: usize = 100;

/// Refuses a mechanism with too few equations. `under`: given, the underdetermined unknowns and their equations.
pub(super) fn nothing_is_free(model: &Model, system: &System, pattern: &Pattern, matching: &Matching, under: &DmPart, diag: &mut Diag) {
    if let Some((bodies, joints)) = passive_spin(model, system) {
        let joints = joints.map(|joint| model.joints[joint].name.to_string());
        let names = bodies.iter().map(|body| model.bodies[*body].name.to_string()).collect();
        diag.refuse::<()>(&model.bodies[bodies[0]].name, SystemFact::PassiveSpin { bodies: names, joints });
        return;
    }
    let has_masses = model.bodies.iter().any(|body| !body.masses.is_empty());
    let drives = drives(model);
    let solved = pattern.rows.iter().filter(|row| !row.is_empty()).count();
    let in_none = in_no_equation(pattern);
    let is_place = |unknown: &usize| system.coordinates[*unknown].role.is_position();
    let body = |unknown: &usize| system.coordinates[*unknown].body;
    let has_no_place = |unknown: &&usize| in_none.iter().filter(|other| is_place(other) && body(other) == body(unknown)).count() > 1;
    // Without any drive, a single undetermined coordinate may be the one that a drive was meant for; a whole position hardly ever is.
    let missing = matching.free_unknowns().len();
    let is_all = drives > 0 && in_none.len() == missing;
    let first = in_none.iter().find(has_no_place).or(in_none.first().filter(|_| is_all));
    if let Some(first) = first {
        let name = &model.bodies[body(first)].name;
        let has_place = !has_no_place(&first);
        let example = if has_place { drive_for(model, system, *first) } else { pin(model, body(first)) };
        let coordinates = driven(model, system, &in_none);
        let freedom = has_masses.then(|| freed(model, system, *first));
        diag.refuse::<()>(name, SystemFact::FreeCoordinates { body: name.to_string(), coordinates, has_place, example, freedom });
        return;
    }
    let [first, second] = candidates(model, system, pattern, under);
    let chosen = chosen(pattern, &[first.as_slice(), &second].concat(), missing.min(MOST_CHOSEN));
    let shown = if missing == 1 { &first } else { &chosen };
    let forgotten = if missing > 1 { forgotten(model, system, pattern, under, &chosen) } else { Forgotten::default() };
    let declared = declared_freedoms(model);
    let count = match &system.declared {
        // Joint angles and quaternions are coordinates that nobody declared.
        Some(_) => {
            let freedoms = 6 * model.bodies.len();
            Count { freedoms, in_space: true, joints: freedoms.saturating_sub(drives + missing), drives, declared, missing }
        }
        None => Count { freedoms: system.coordinates.len(), in_space: false, joints: solved - drives, drives, declared, missing },
    };
    let fact = SystemFact::DrivesMissing {
        name: model.name.to_string(),
        count: Box::new(count),
        forgotten: Box::new(forgotten),
        candidates: driven(model, system, shown),
        example: chosen.first().map_or(String::new(), |unknown| drive_for(model, system, *unknown)),
        freedom: chosen.first().filter(|_| has_masses).map(|unknown| format!("freedom name = {};", freed(model, system, *unknown))),
    };
    diag.refuse::<()>(&model.name, fact);
}

/// In space: a body, or bodies that are joined to each other, which two joints hold by one point each and nothing else, so that they can turn
/// about the line through both.
fn passive_spin(model: &Model, system: &System) -> Option<(Vec<usize>, [usize; 2])> {
    let declared = system.declared.as_ref()?;
    let mut joined: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for equation in &declared.equations {
        joined.entry(equation.joint).or_default().extend(equation.jacobian.iter().map(|(speed, _)| Ambient::Space.body_of(*speed)));
    }
    let is_ball = |joint: usize| {
        let of_it =
            |(other, _, relation): &&(usize, usize, Relationship)| *other == joint && matches!(relation, Relationship::Coincident(..));
        model.joints[joint].residuals.len() == 3 && model.space.relations.iter().any(|relation| of_it(&relation))
    };
    let (balls, others): (Vec<_>, Vec<_>) = joined.into_iter().partition(|(joint, _)| is_ball(*joint));
    (0..model.bodies.len()).find_map(|first| {
        let mut own = BTreeSet::from([first]);
        loop {
            let touching: Vec<&BTreeSet<usize>> =
                others.iter().map(|(_, bodies)| bodies).filter(|bodies| !bodies.is_disjoint(&own)).collect();
            // A joint of one body holds it to ground.
            if touching.iter().any(|bodies| bodies.len() == 1) {
                return None;
            }
            let more: BTreeSet<usize> = touching.into_iter().flatten().copied().filter(|body| !own.contains(body)).collect();
            if more.is_empty() {
                break;
            }
            own.extend(more);
        }
        let held: Vec<&(usize, BTreeSet<usize>)> = balls.iter().filter(|(_, bodies)| !bodies.is_disjoint(&own)).collect();
        match held.as_slice() {
            [(one, to), (two, from)] if [to, from].into_iter().all(|bodies| bodies.intersection(&own).count() == 1) => {
                Some((own.into_iter().collect(), [*one, *two]))
            }
            _ => None,
        }
    })
}

/// Names of coordinates that a drive could prescribe; of a body that turns in space, its orientation.
pub(super) fn driven(model: &Model, system: &System, unknowns: &[usize]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for unknown in unknowns {
        let coordinate = &system.coordinates[*unknown];
        let name = match coordinate.role {
            Role::Quaternion(_) => format!("{}.orientation", model.bodies[coordinate.body].name),
            _ => system.name(model, *unknown),
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The expression of a freedom that a coordinate belongs to.
fn freed(model: &Model, system: &System, unknown: usize) -> String {
    let coordinate = &system.coordinates[unknown];
    let turns = coordinate.of_joint.is_some_and(|(joint, word)| word.starts_with("angle_") && model.joints[joint].kind != "universal");
    match coordinate.role {
        _ if turns => format!("{}.angular_velocity", model.bodies[coordinate.body].name),
        Role::Quaternion(_) => format!("{}.angular_velocity", model.bodies[coordinate.body].name),
        _ => system.name(model, unknown),
    }
}

/// Unknowns that occur in no equation.
fn in_no_equation(pattern: &Pattern) -> Vec<usize> {
    let held: BTreeSet<usize> = pattern.rows.iter().flatten().map(|entry| entry.unknown).collect();
    (0..pattern.unknowns).filter(|unknown| !held.contains(unknown)).collect()
}

/// Unknowns that a drive could prescribe: angles of bodies joined to ground, as cranks are, then other angles; then positions, which come
/// first if there are no angles.
fn candidates(model: &Model, system: &System, pattern: &Pattern, under: &DmPart) -> [Vec<usize>; 2] {
    let body = |entry: &Entry| system.coordinates[entry.unknown].body;
    let is_on_ground = |row: &&Vec<Entry>| row.iter().all(|entry| body(entry) == body(&row[0]));
    let joints = pattern.rows.iter().zip(&system.equations).filter(|(_, equation)| !model.joints[equation.joint].is_drive);
    let on_ground: BTreeSet<usize> =
        joints.map(|(row, _)| row).filter(|row| !row.is_empty()).filter(is_on_ground).map(|row| body(&row[0])).collect();
    let (mut angles, mut places): (Vec<usize>, Vec<usize>) =
        under.unknowns.iter().partition(|unknown| system.coordinates[**unknown].role == Role::Angle);
    for candidates in [&mut angles, &mut places] {
        candidates.sort_by_key(|unknown| !on_ground.contains(&system.coordinates[*unknown].body));
    }
    if angles.is_empty() { [places, angles] } else { [angles, places] }
}

/// Finds a body with an undetermined position and no joint at it, which may have lost the joint that held it. Bodies that would be driven
/// are tested first, then bodies with only one neighbour.
fn forgotten(model: &Model, system: &System, pattern: &Pattern, under: &DmPart, chosen: &[usize]) -> Forgotten {
    let loose = loose_ends(model, system, pattern, under);
    let place = |body: usize| {
        if model.sketch.joints.is_empty() || example::is_joined(model, body) {
            return None;
        }
        let is_meant =
            |unknown: usize, axis| system.coordinates[unknown].body == body && system.coordinates[unknown].role == Role::Position(axis);
        let unknown = |axis| under.unknowns.iter().copied().find(|unknown| is_meant(*unknown, axis));
        Some([unknown(Axis::X)?, unknown(Axis::Y)?])
    };
    let bodies: BTreeSet<usize> = under.unknowns.iter().map(|unknown| system.coordinates[*unknown].body).collect();
    let mut places: Vec<(usize, [usize; 2])> = bodies.into_iter().filter_map(|body| Some((body, place(body)?))).collect();
    places.sort_by_key(|(body, place)| (!place.iter().all(|unknown| chosen.contains(unknown)), !loose.contains(body)));
    let can_be_held = |place: &[usize; 2]| {
        let mut held = pattern.clone();
        held.rows.extend(place.iter().map(|unknown| vec![Entry { unknown: *unknown, is_pivot: true }]));
        every_row_finds_an_unknown(&held)
    };
    let held = places.into_iter().take(MOST_TRIED).find(|(_, place)| can_be_held(place));
    Forgotten {
        loose: loose.into_iter().map(|body| model.bodies[body].name.to_string()).collect(),
        line: held.map(|(body, _)| pin(model, body)),
        holds: held.into_iter().flat_map(|(_, place)| place).map(|unknown| system.name(model, unknown)).collect(),
    }
}

/// True if every row is matched to an unknown; checked rows, which are empty here, are ignored.
fn every_row_finds_an_unknown(pattern: &Pattern) -> bool {
    maximum(pattern).free_equations().into_iter().all(|row| pattern.rows[row].is_empty())
}

/// A joint of a body with ground, ready to be typed.
fn pin(model: &Model, body: usize) -> String {
    example::joint(model, &example::place_of_ground(model), &example::place_of(model, body))
}

/// Bodies with remaining freedom and only one neighbour, another body or ground: a joint may be missing there.
fn loose_ends(model: &Model, system: &System, pattern: &Pattern, under: &DmPart) -> Vec<usize> {
    let mut neighbours: BTreeMap<usize, BTreeSet<Option<usize>>> = BTreeMap::new();
    for (row, equation) in pattern.rows.iter().zip(&system.equations) {
        let bodies: BTreeSet<usize> = row.iter().map(|entry| system.coordinates[entry.unknown].body).collect();
        for body in bodies.iter().filter(|_| !model.joints[equation.joint].is_drive) {
            let others = bodies.iter().filter(|other| *other != body).map(|other| Some(*other));
            neighbours.entry(*body).or_default().extend(others.chain((bodies.len() == 1).then_some(None)));
        }
    }
    let has_freedom: BTreeSet<usize> = under.unknowns.iter().map(|unknown| system.coordinates[*unknown].body).collect();
    neighbours.into_iter().filter(|(body, others)| others.len() == 1 && has_freedom.contains(body)).map(|(body, _)| body).collect()
}

/// A largest set of candidates that can be driven together, at most `most`.
fn chosen(pattern: &Pattern, candidates: &[usize], most: usize) -> Vec<usize> {
    let mut driven = pattern.clone();
    let mut chosen = Vec::new();
    for unknown in candidates {
        if chosen.len() == most {
            break;
        }
        driven.rows.push(vec![Entry { unknown: *unknown, is_pivot: true }]);
        if every_row_finds_an_unknown(&driven) {
            chosen.push(*unknown);
        } else {
            driven.rows.pop();
        }
    }
    chosen
}

/// A drive of a coordinate, ready to be typed.
fn drive_for(model: &Model, system: &System, unknown: usize) -> String {
    let taken = |name: &&&str| model.joints.iter().all(|joint| joint.name.path != **name);
    let name = ["input", "motor", "feed", "drive_1"].iter().find(taken).unwrap_or(&"another");
    let unknown = &system.coordinates[unknown];
    let body = &model.bodies[unknown.body].name;
    let joint = unknown.of_joint.map(|(joint, word)| (&model.joints[joint].name.path, word));
    match unknown.role {
        _ if joint.is_some_and(|(_, word)| word == "angle") => {
            format!("drive {name} = drive_rotation({}, 60rpm * t);", joint.map_or("", |(joint, _)| joint))
        }
        _ if unknown.of_joint.is_some_and(|(joint, word)| word.starts_with("angle_") && model.joints[joint].kind == "universal") => {
            let (joint, word) = joint.unwrap_or((&body.path, "angle_a"));
            format!("drive {name} = drive_rotation({joint}.{word}, 10deg * sin(1rad_s * t));")
        }
        _ if joint.is_some_and(|(_, word)| word == "displacement") => {
            format!("drive {name} = drive_translation({}, 10mm * sin(1rad_s * t));", joint.map_or("", |(joint, _)| joint))
        }
        // No single drive holds a part of an orientation.
        _ if model.ambient == Ambient::Space && !matches!(unknown.role, Role::Position(_)) => String::new(),
        Role::Position(_) => format!("drive {name} = drive_{}({body}.position, 10mm * sin(1rad_s * t));", unknown.role.name()),
        Role::Displacement => format!("drive {name} = drive_translation({body}, 10mm * sin(1rad_s * t));"),
        Role::Angle | Role::Quaternion(_) => format!("drive {name} = drive_angle({body}, 60rpm * t);"),
    }
}

/// Number of equations of drives.
fn drives(model: &Model) -> usize {
    model.joints.iter().filter(|joint| joint.is_drive).map(|joint| joint.residuals.len()).sum()
}

/// Number of equations of the freedoms, which are among those of the drives.
fn declared_freedoms(model: &Model) -> usize {
    model.joints.iter().filter(|joint| joint.freedom.is_some()).map(|joint| joint.residuals.len()).sum()
}
