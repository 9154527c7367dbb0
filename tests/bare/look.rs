//! Inspects the machine code of the mechanisms beside this file, compiled as for a small machine: with whole-program optimisation, for
//! speed and for size. `cargo run -p reuleaux-bare --bin look [-- TARGET]`
//!
//! Neither version may contain a path to a panic, and in `f32` no arithmetic with doubles. The inspected text is the assembly that rustc
//! writes, for x86-64 or for an Arm without doubles, so that only Rust is needed. It takes some minutes.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// Forbidden instructions: for each function and name, the number of occurrences.
type Found = BTreeMap<(String, String), usize>;

fn main() -> Result<(), Box<dyn Error>> {
    let target = env::args().nth(1);
    let mut failed = Vec::new();
    for level in ["3", "\"s\""] {
        let (lines, wrong) = inspected(target.as_deref(), level)?;
        print!("{lines}");
        failed.extend(wrong);
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ").into()) }
}

/// The findings at a level of optimisation, and the versions at fault.
fn inspected(target: Option<&str>, level: &str) -> Result<(String, Vec<String>), Box<dyn Error>> {
    let (mut lines, mut failed) = (String::new(), Vec::new());
    for features in ["alone", "alone,single"] {
        let assembly = assembly(target, features, level)?;
        let title = format!("opt-level {level}, {features}");
        if !computes(&assembly) {
            return Err(format!("{title}: no arithmetic that is known here").into());
        }
        let mut found = look(&assembly, panics);
        writeln!(lines, "{title}: {} lines, {} calls of what panics", assembly.lines().count(), found.values().sum::<usize>())?;
        if features.contains("single") {
            let doubles = look(&assembly, doubles);
            writeln!(lines, "{title}: {} operations on doubles", doubles.values().sum::<usize>())?;
            found.extend(doubles);
        }
        for ((function, what), times) in &found {
            writeln!(lines, "    {times} × {what} in {function}")?;
        }
        if !found.is_empty() {
            failed.push(title);
        }
    }
    Ok((lines, failed))
}

/// The assembly of the library, with everything that it uses.
fn assembly(target: Option<&str>, features: &str, level: &str) -> Result<String, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/bare");
    fs::create_dir_all(&folder)?;
    let file = folder.join("bare.s");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    // The profile of tests with the settings of a release; macros have little to do.
    cargo.args(["rustc", "--quiet", "--package", "reuleaux-bare", "--lib", "--crate-type", "staticlib", "--features", features]);
    // A folder of its own, so that other builds need not wait.
    cargo.arg("--target-dir").arg(&folder);
    let level = format!("opt-level={level}");
    let release = ["debug-assertions=false", "overflow-checks=false", "incremental=false", "package.reuleaux-compiler.opt-level=0"];
    for setting in ["lto=\"fat\"", "panic=\"abort\"", "codegen-units=1", &level].into_iter().chain(release) {
        cargo.args(["--config", &format!("profile.dev.{setting}")]);
    }
    if let Some(target) = target {
        cargo.args(["--target", target]);
    }
    // Cargo does not track the assembly file; a new `cfg` makes rustc write it again.
    let run = std::process::id();
    cargo.args(["--", &format!("--emit=asm={}", file.display()), "--cfg", &format!("run=\"{run}\""), "--allow", "unexpected_cfgs"]);
    // Flags of an outer build do not apply here.
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    if !cargo.status()?.success() {
        return Err(format!("it was not built with {features}").into());
    }
    Ok(fs::read_to_string(file)?)
}

/// Counts the instructions of each function that `is_bad` names.
fn look(assembly: &str, is_bad: fn(&str) -> Option<&str>) -> Found {
    let mut function = "";
    let mut found = Found::new();
    for line in assembly.lines() {
        match line.strip_prefix('\t') {
            Some(instruction) if !instruction.starts_with('.') => {
                if let Some(what) = is_bad(instruction) {
                    *found.entry((function.to_owned(), what.to_owned())).or_default() += 1;
                }
            }
            Some(_) => {}
            None => function = line.strip_suffix(':').filter(|label| !label.starts_with('.')).unwrap_or(function),
        }
    }
    found
}

/// The panicking function that an instruction calls, if any.
fn panics(instruction: &str) -> Option<&str> {
    let operand = instruction.split_whitespace().nth(1)?;
    ["9panicking", "rust_begin_unwind"].iter().any(|name| operand.contains(name)).then_some(operand)
}

/// The arithmetic, comparison or conversion of doubles in an instruction, if any. Moves of eight bytes are allowed.
fn doubles(instruction: &str) -> Option<&str> {
    let mut words = instruction.split_whitespace();
    let (name, operand) = (words.next()?, words.next().unwrap_or(""));
    let of_arm = operand.strip_prefix("__aeabi_").filter(|routine| {
        // Routines that begin with c are comparisons.
        let routine = routine.trim_start_matches('c');
        routine.starts_with('d') && !routine.starts_with("div") || routine.ends_with("2d")
    });
    if of_arm.is_some() {
        return Some(operand);
    }
    let arithmetic = ["add", "sub", "mul", "div", "sqrt", "max", "min", "cmp", "ucomi", "comi", "cvt", "round", "fm", "fnm", "hadd", "dp"];
    let x86 = name.trim_start_matches('v');
    let is_x86 = arithmetic.iter().any(|start| x86.starts_with(start)) && (x86.contains("sd") || x86.contains("pd"));
    let is_arm = name.contains(".f64") && !name.starts_with("vmov");
    (is_x86 || is_arm).then_some(name)
}

/// True if the assembly contains multiplications.
fn computes(assembly: &str) -> bool {
    ["mulss", "mulsd", "vmul.f32", "__aeabi_dmul"].iter().any(|name| assembly.contains(name))
}

#[cfg(test)]
mod tests {
    use super::{doubles, look, panics};

    #[test]
    fn panics_are_found_in_their_function() {
        let assembly =
            "one:\n\tbl\t_RNvNtCs5Vd0OyIvoTp_4core9panicking18panic_bounds_check\n.Lhere:\n\t.ascii \"panicking\"\ntwo:\n\tret\n";
        let found = look(assembly, panics);
        assert_eq!(found.len(), 1);
        assert!(found.keys().all(|(function, _)| function == "one"));
    }

    #[test]
    fn doubles_are_found_on_both_machines() {
        for bad in [
            "mulsd %xmm1, %xmm0",
            "vfmadd213pd x",
            "cvtss2sd %xmm0, %xmm0",
            "ucomisd %xmm0, %xmm1",
            "bl\t__aeabi_dmul",
            "bl __aeabi_f2d",
            "bl __aeabi_cdcmple",
            "vadd.f64 d0, d0, d1",
        ] {
            assert!(doubles(bad).is_some(), "{bad}");
        }
        for good in [
            "mulss %xmm1, %xmm0",
            "movsd (%rax), %xmm0",
            "movapd %xmm0, %xmm1",
            "cvtsi2ss %eax, %xmm0",
            "cvttss2si x",
            "bl __aeabi_memcpy8",
            "bl\t__aeabi_fmul",
            "vmul.f32 s0, s1",
            "bl __aeabi_uldivmod",
        ] {
            assert!(doubles(good).is_none(), "{good}");
        }
    }
}
