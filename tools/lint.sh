#!/usr/bin/env bash
# What cargo runs for the compiler, with that and its arguments, where crates of this workspace are linted while they are compiled
# (RUSTC_WORKSPACE_WRAPPER). Clippy compiles too, but leaves all optimization to LLVM. Natively that makes no difference; modules of
# wasm take a quarter longer, so that these are linted first, and then compiled as they always are.
set -euo pipefail

compiler=$1
shift
linter=$(dirname "$compiler")/clippy-driver
if [ ! -x "$linter" ]; then linter=clippy-driver; fi

case " $* " in
  *" --crate-name ___ "* | *" -vV "*) exec "$compiler" "$@" ;; # Cargo asks what the compiler is, and what it can do.
  *" wasm32-unknown-unknown "*) ;;
  *) exec "$linter" "$compiler" "$@" ;;
esac

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# Nothing is compiled, and cargo is not told of files that are not there yet.
checking=()
for argument in "$@"; do
  case $argument in
    --emit=*) argument=--emit=metadata ;;
    --json=*) argument=${argument/artifacts,/} ;;
    incremental=*) argument=incremental=$folder/incremental ;;
  esac
  if [ "${before:-}" = --out-dir ]; then argument=$folder; fi
  checking+=("$argument")
  before=$argument
done
"$linter" "$compiler" "${checking[@]}"
"$compiler" "$@"
