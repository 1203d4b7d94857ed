//! Hostile meshes by random numbers, answered by all methods and held against right distances, as Markdown. Exits with 1
//! where an answer is wrong.
//!
//! `cargo run --release -p heatwalk --example truth -- thin|developable|nasty [COUNT] [FIRST SEED]`; with `--mesh SEED`
//! instead of a count, the mesh of that seed as OFF.

#[path = "../tests/common/truth/mod.rs"]
mod truth;

use std::collections::BTreeMap;
use std::error::Error;
use std::process::{Command, ExitCode, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use heatwalk::Method;
use serde_json::{Value, json};
use truth::Case;
use truth::examine::{Examined, Findings, METHODS};

/// Meshes of each method that are named, those with the largest errors.
const NAMED: usize = 12;

/// How long a mesh may take. None takes a second that ends.
const PATIENCE: Duration = Duration::from_secs(10);

/// What is said of one that takes longer.
const ENDLESS: &str = "does not end";

/// How often it is looked whether a mesh is done.
const PAUSE: Duration = Duration::from_millis(1);

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let family = arguments.first().map_or("", String::as_str);
    let make: fn(u64) -> Case = match family {
        "thin" => truth::thin::case,
        "developable" => truth::developable::case,
        "nasty" => truth::nasty::case,
        _ => return Err("name thin, developable or nasty".into()),
    };
    let number = |at: usize, default| arguments.get(at).map_or(Ok(default), |text| text.parse::<u64>());
    match arguments.get(1).map(String::as_str) {
        Some("--mesh") => print_off(&make(number(2, 0)?)),
        Some("--answer") => answer(&make(number(2, 0)?), number(2, 0)?, &arguments[3..])?,
        _ => return Ok(examine_all(family, number(2, 0)?, number(1, 1000)?).report()),
    }
    Ok(ExitCode::SUCCESS)
}

/// One line of JSON when brute force is done, and one for each method, as soon as it is; none where nothing is left of the mesh.
fn answer(case: &Case, seed: u64, methods: &[String]) -> Result<(), Box<dyn Error>> {
    let Some(mut examined) = Examined::new(case, seed)? else { return Ok(()) };
    println!("{}", json!({ "kind": case.kind }));
    for method in methods {
        let Findings { answers, wrong, lost, asymmetric, steep, worst } = examined.findings(method.parse()?)?;
        let counts = [answers, wrong, lost, asymmetric, steep];
        println!("{}", json!({ "kind": case.kind, "counts": counts, "worst": worst }));
    }
    Ok(())
}

/// Meshes from this seed on, on all processors.
fn examine_all(family: &str, first: u64, count: u64) -> Tally {
    let (next, tally) = (AtomicU64::new(first), Mutex::new(Tally::default()));
    let work = || {
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= first + count {
                return;
            }
            examine(family, seed, &tally).expect("this program runs");
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| (0..threads).for_each(|_| _ = scope.spawn(work)));
    tally.into_inner().expect("no thread panics")
}

/// Asks a process of its own, which may fail and need not end. Then the methods after the one at fault get another.
fn examine(family: &str, seed: u64, tally: &Mutex<Tally>) -> Result<(), Box<dyn Error>> {
    let mut methods = METHODS.as_slice();
    while !methods.is_empty() {
        let mut child = Command::new(std::env::current_exe()?)
            .args([family, "--answer", &seed.to_string()])
            .args(methods.iter().map(Method::to_string))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let start = Instant::now();
        let fault = loop {
            match child.try_wait()? {
                Some(status) if status.success() => break None,
                Some(_) => break Some("fails"),
                None if start.elapsed() > PATIENCE => {
                    child.kill()?;
                    break Some(ENDLESS);
                }
                None => thread::sleep(PAUSE),
            }
        };
        let output = child.wait_with_output()?;
        let mut tally = tally.lock().expect("no thread panics");
        let told = String::from_utf8(output.stdout)?;
        let mut lines = told.lines();
        if lines.next().is_none() && fault == Some(ENDLESS) {
            tally.unknown.push(seed);
            return Ok(());
        }
        for line in lines {
            tally.add(seed, methods[0], &serde_json::from_str(line)?);
            methods = &methods[1..];
        }
        match (fault, methods) {
            (Some(fault), [method, rest @ ..]) => {
                let words = String::from_utf8_lossy(&output.stderr).lines().take(3).collect::<Vec<_>>().join(" ");
                tally.failures.push(format!("{method}, seed {seed} {fault} {words}"));
                methods = rest;
            }
            _ => break,
        }
    }
    Ok(())
}

/// What was found, by method.
#[derive(Default)]
struct Tally {
    meshes: BTreeMap<(String, String), (usize, Findings)>,
    faults: BTreeMap<String, Vec<Fault>>,
    failures: Vec<String>,
    /// Meshes that brute force does not end on.
    unknown: Vec<u64>,
}

/// A mesh with wrong answers.
struct Fault {
    seed: u64,
    kind: String,
    found: Findings,
}

impl Tally {
    fn add(&mut self, seed: u64, method: Method, line: &Value) {
        let kind = line["kind"].as_str().unwrap_or_default().to_owned();
        let [answers, wrong, lost, asymmetric, steep] =
            [0, 1, 2, 3, 4].map(|k| line["counts"][k].as_u64().unwrap_or(0) as usize);
        let worst = line["worst"].as_f64().unwrap_or(f64::INFINITY);
        let found = Findings { answers, wrong, lost, asymmetric, steep, worst };
        let (meshes, sum) = self.meshes.entry((method.to_string(), kind.clone())).or_default();
        *meshes += 1;
        sum.add(&found);
        if !found.is_right() {
            self.faults.entry(method.to_string()).or_default().push(Fault { seed, kind, found });
        }
    }

    fn report(mut self) -> ExitCode {
        let columns = "answers | wrong | lost | asymmetric | steep edges | largest error / extent |";
        println!("| method | kind | meshes | {columns}\n|---|---|---:|---:|---:|---:|---:|---:|---:|");
        for ((method, kind), (meshes, found)) in &self.meshes {
            println!("| {method} | {kind} | {meshes} {}", row(found));
        }
        for (method, faults) in &mut self.faults {
            println!("\n{method} is wrong on {} meshes, most on:\n", faults.len());
            println!("| seed | kind | {columns}\n|---:|---|---:|---:|---:|---:|---:|---:|");
            faults.sort_by(|a, b| b.found.lost.cmp(&a.found.lost).then(b.found.worst.total_cmp(&a.found.worst)));
            for Fault { seed, kind, found } in faults.iter().take(NAMED) {
                println!("| {seed} | {kind} {}", row(found));
            }
        }
        println!("\nBrute force does not end on {} meshes: {:?}", self.unknown.len(), self.unknown);
        println!("\n{} failures", self.failures.len());
        self.failures.iter().for_each(|failure| println!("- {failure}"));
        if self.faults.is_empty() && self.failures.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

fn row(found: &Findings) -> String {
    let Findings { answers, wrong, lost, asymmetric, steep, worst } = found;
    format!("| {answers} | {wrong} | {lost} | {asymmetric} | {steep} | {worst:.1e} |")
}

fn print_off(case: &Case) {
    println!("OFF\n{} {} 0", case.soup.positions.len(), case.soup.triangles.len());
    case.soup.positions.iter().for_each(|position| println!("{:?} {:?} {:?}", position.x, position.y, position.z));
    case.soup.triangles.iter().for_each(|[a, b, c]| println!("3 {a} {b} {c}"));
}
