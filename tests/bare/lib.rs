//! Mechanisms of all kinds, solved in every way that the library has, without a standard library and without an allocator.
//!
//! The bin `look` compiles this as it would be for a small machine, and looks at what has become of it.

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
