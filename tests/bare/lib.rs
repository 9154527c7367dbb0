//! Mechanisms of all kinds, solved in all ways of the library, without a standard library and without an allocator.
//!
//! The binary `look` compiles this crate as for a small machine, and inspects the machine code.

#![no_std]
#![allow(dead_code, unreachable_pub, missing_docs)]

/// The number type.
#[cfg(feature = "single")]
type T = f32;
#[cfg(not(feature = "single"))]
type T = f64;

include!(concat!(env!("OUT_DIR"), "/mechanisms.rs"));

#[cfg(feature = "alone")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
