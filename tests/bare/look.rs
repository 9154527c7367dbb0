//! Looks at the machine code of the mechanisms beside this file, as it is for a small machine: whole-program optimised, for speed and for
//! size. `cargo run -p reuleaux-bare --bin look [-- TARGET]`
//!
//! In neither is there a way to a panic, and in `f32` there is nothing that computes with doubles. What is looked at is the assembly
//! that rustc writes, of x86-64 or of an Arm without doubles, so that nothing is needed but Rust. It takes some minutes.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// What must not be there: by function, how often which.
type Found = BTreeMap<(String, String), usize>;

fn main() -> Result<(), Box<dyn Error>> {
    let target = env::args().nth(1);
    let mut failed = Vec::new();
    for level in ["3", "\"s\""] {
        for features in ["alone", "alone,single"] {
            let assembly = assembly(target.as_deref(), features, level)?;
            let title = format!("opt-level {level}, {features}");
            if !computes(&assembly) {
                return Err(format!("{title}: no arithmetic that is known here").into());
            }
            let mut found = look(&assembly, panics);
            println!("{title}: {} lines, {} calls of what panics", assembly.lines().count(), found.values().sum::<usize>());
            if features.contains("single") {
                let doubles = look(&assembly, doubles);
                println!("{title}: {} operations on doubles", doubles.values().sum::<usize>());
                found.extend(doubles);
            }
            for ((function, what), times) in &found {
                println!("    {times} × {what} in {function}");
            }
            if !found.is_empty() {
                failed.push(title);
            }
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ").into()) }
}

/// The assembly of the library, with all that it uses.
fn assembly(target: Option<&str>, features: &str, level: &str) -> Result<String, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/bare");
    fs::create_dir_all(&folder)?;
    let file = folder.join("bare.s");
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    // The profile of tests, made that of a release: so that macros are not built once more.
    cargo.args(["rustc", "--quiet", "--package", "reuleaux-bare", "--lib", "--crate-type", "staticlib", "--features", features]);
    let level = format!("opt-level={level}");
    let release = ["debug=false", "debug-assertions=false", "overflow-checks=false", "incremental=false"];
    for setting in ["lto=\"fat\"", "panic=\"abort\"", "codegen-units=1", &level].into_iter().chain(release) {
        cargo.args(["--config", &format!("profile.dev.{setting}")]);
    }
    if let Some(target) = target {
        cargo.args(["--target", target]);
    }
    // Cargo does not know of this file, and would not write it again.
    let run = std::process::id();
    cargo.args(["--", &format!("--emit=asm={}", file.display()), "--cfg", &format!("run=\"{run}\""), "--allow", "unexpected_cfgs"]);
    // What is built around this says how that is built.
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    if !cargo.status()?.success() {
        return Err(format!("it was not built with {features}").into());
    }
    Ok(fs::read_to_string(file)?)
}

/// What `is_bad` names in the instructions of each function.
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

/// What an instruction calls that panics.
fn panics(instruction: &str) -> Option<&str> {
    let operand = instruction.split_whitespace().nth(1)?;
    ["9panicking", "rust_begin_unwind"].iter().any(|name| operand.contains(name)).then_some(operand)
}

/// What an instruction does with doubles: computes, compares or converts. They may be moved: eight bytes are eight bytes.
fn doubles(instruction: &str) -> Option<&str> {
    let mut words = instruction.split_whitespace();
    let (name, operand) = (words.next()?, words.next().unwrap_or(""));
    let of_arm = operand.strip_prefix("__aeabi_").filter(|routine| {
        // Those that begin with c compare.
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

/// There are products of numbers.
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
