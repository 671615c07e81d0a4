#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| ypsilon_fuzz::readers::studies::study(bytes));
