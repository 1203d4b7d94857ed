//! Runs tests that are compiled for wasm32, under Node: `wasm-test-runner FILE.wasm [NAME]`. Apart from `xtask`, since it is
//! half of what a first start would have to compile, and only tests need it.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
