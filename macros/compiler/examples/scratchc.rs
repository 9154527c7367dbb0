//! scratch
use std::str::FromStr;
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let tokens = proc_macro2::TokenStream::from_str(&text).unwrap();
    let t = std::time::Instant::now();
    match reuleaux_compiler::compile(tokens.clone()) {
        Ok(found) => {
            println!("coordinates {:?}", found.system.coordinates.iter().map(|c| (c.body, c.role)).collect::<Vec<_>>());
            println!("equations {} blocks {:?}", found.system.equations.len(), found.structure.blocks.iter().map(|b| b.iterated.len()).collect::<Vec<_>>());
            println!("start {:?}", found.assembly.start);
        }
        Err(all) => for refusal in all { println!("{} [{}]", refusal.fact, refusal.fact.code()); },
    }
    println!("{:?}", t.elapsed());
    let out = reuleaux_compiler::mechanism(tokens);
    std::fs::write("/tmp/out.rs", out.to_string()).unwrap();
    std::fs::write("/tmp/out.rs", out.to_string()).unwrap();
    println!("{} tokens {:?}", out.to_string().len(), t.elapsed());
}
