//! Every constraint of space at states that do not satisfy it: Φ, Φ_u, ν and γ by the interpreter against reference numbers.

use super::declaration::Declaration;
use reuleaux_compiler::expr::{Evaluator, Values};
use reuleaux_tests::common::decimal::Decimal;
use reuleaux_tests::common::reference::{Value, file, list, number, text};

/// Rows of a declaration at a state: Φ, the rows of Φ_u, ν and γ.
pub(crate) struct Rows {
    pub(crate) phi: Vec<f64>,
    pub(crate) jacobian: Vec<Vec<f64>>,
    pub(crate) nu: Vec<f64>,
    pub(crate) gamma: Vec<f64>,
}

pub(crate) fn rows(case: &Value) -> Rows {
    let mut declaration = Declaration::default();
    declaration.add(&case["constraint"], "");
    let bodies: Vec<(String, String)> = list(&case["bodies"]).iter().map(|body| (text(&body["name"]).to_owned(), String::new())).collect();
    let text = declaration.text("#[equations_only] pub mechanism Case in space", &bodies);
    let compiled = reuleaux_compiler::compile(text.parse().expect("tokens")).unwrap_or_else(|refusals| {
        let sentences: Vec<String> = refusals.iter().map(|refusal| refusal.fact.to_string()).collect();
        panic!("{}\n{text}", sentences.join("\n"))
    });
    let declared = compiled.system.declared.expect("a mechanism in space");
    let mut q: Vec<f64> = list(&case["bodies"])
        .iter()
        .flat_map(|body| ["r", "p"].into_iter().flat_map(|name| list(&body[name]).iter().map(number)))
        .collect();
    let u: Vec<f64> = list(&case["bodies"])
        .iter()
        .flat_map(|body| ["v", "w"].into_iter().flat_map(|name| list(&body[name]).iter().map(number)))
        .collect();
    // The angles of joints, which the state of a mechanism holds.
    if let Some(angles) = case["theta"].as_object() {
        let order = ["theta", "theta_i", "theta_j"];
        q.extend(order.iter().filter_map(|name| angles.get(*name)).map(|angle| Decimal::parse(self::text(angle)).value));
    }
    q.resize(declared.coordinates, 0.0);
    let t = case["t"].as_f64().unwrap_or(0.0);
    let functions = |_: u32, _: f64| [f64::NAN; 3];
    let values = Values { time: t, parameters: &[], coordinates: &q, speeds: &u, accelerations: &[], functions: &functions };
    let mut roots = Vec::new();
    for equation in &declared.equations {
        roots.push(equation.phi().unwrap_or(equation.nu));
        roots.extend([equation.nu, equation.gamma]);
        roots.extend(equation.jacobian.iter().map(|(_, entry)| *entry));
    }
    let mut found = vec![f64::NAN; roots.len()];
    Evaluator::new(&declared.arena, &roots).run(&values, &mut found);
    let mut found = found.into_iter();
    let mut next = || found.next().expect("a result");
    let mut rows = Rows { phi: Vec::new(), jacobian: Vec::new(), nu: Vec::new(), gamma: Vec::new() };
    for equation in &declared.equations {
        rows.phi.push(next());
        rows.nu.push(next());
        rows.gamma.push(next());
        let mut row = vec![0.0; declared.speeds];
        equation.jacobian.iter().for_each(|(column, _)| row[*column] = next());
        rows.jacobian.push(row);
    }
    rows
}

/// The worst error of some numbers, in units of 16 bounds and 8 roundings of the largest.
fn worst(found: &[f64], wanted: &Value, bounds: &Value) -> f64 {
    let wanted: Vec<Decimal> = list(wanted).iter().map(|entry| Decimal::parse(text(entry))).collect();
    assert_eq!(found.len(), wanted.len());
    let largest = wanted.iter().map(|entry| entry.value.abs()).fold(0.0, f64::max);
    let errors = found.iter().zip(&wanted).zip(list(bounds)).map(|((found, wanted), bound)| {
        let allowed = 16.0 * number(bound) + 4.0 * f64::EPSILON * largest;
        let error = wanted.error_of(*found);
        if error == 0.0 { 0.0 } else { error / allowed }
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn every_constraint_has_its_reference_rows_at_states_that_do_not_satisfy_it() {
    let all = file("space/unit_constraints.json");
    for case in list(&all["cases"]) {
        let (rows, name) = (rows(case), text(&case["id"]));
        let check = |what: &str, found: &[f64], wanted: &Value, bounds: &Value| {
            let error = worst(found, wanted, bounds);
            assert!(error <= 1.0, "{name}, {what}: {error} of what is allowed\n{found:?}\n{wanted}");
        };
        check("Φ", &rows.phi, &case["Phi"], &case["Phi_bound"]);
        check("ν", &rows.nu, &case["nu"], &case["nu_bound"]);
        check("γ", &rows.gamma, &case["gamma"], &case["gamma_bound"]);
        for (row, found) in rows.jacobian.iter().enumerate() {
            check("Φ_u", found, &case["Phi_w"][row], &case["Phi_w_bound"][row]);
        }
    }
}

#[test]
fn every_row_of_velocities_has_its_reference_entries() {
    let all = file("space/unit_velocity_rows.json");
    for case in list(&all["cases"]) {
        let (rows, name) = (rows(case), text(&case["id"]));
        let check = |what: &str, found: &[f64], wanted: &Value, bounds: &Value| {
            let error = worst(found, wanted, bounds);
            assert!(error <= 1.0, "{name}, {what}: {error} of what is allowed\n{found:?}\n{wanted}");
        };
        check("ν", &rows.nu, &case["nu"], &case["nu_bound"]);
        check("γ", &rows.gamma, &case["gamma"], &case["gamma_bound"]);
        for (row, found) in rows.jacobian.iter().enumerate() {
            check("Φ_u", found, &case["Phi_w"][row], &case["Phi_w_bound"][row]);
        }
    }
}
