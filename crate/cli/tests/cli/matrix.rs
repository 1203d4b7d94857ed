//! Matrices: what they hold, and that they are finished after an end in the middle.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use rawzip::ZipArchive;

use crate::{distances, folder, json, refused, run, succeed};

/// The shape and the numbers of an `.npy` file of doubles or floats.
fn npy(bytes: &[u8]) -> (String, Vec<f64>) {
    assert!(bytes.starts_with(b"\x93NUMPY\x01\x00"));
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0);
    let header = String::from_utf8(bytes[10..10 + length].to_vec()).unwrap();
    let body = &bytes[10 + length..];
    let numbers = if header.contains("'<f8'") {
        body.as_chunks::<8>().0.iter().map(|&number| f64::from_le_bytes(number)).collect()
    } else if header.contains("'<f4'") {
        body.as_chunks::<4>().0.iter().map(|&number| f64::from(f32::from_le_bytes(number))).collect()
    } else if header.contains("'<i4'") {
        body.as_chunks::<4>().0.iter().map(|&number| f64::from(i32::from_le_bytes(number))).collect()
    } else {
        body.as_chunks::<8>().0.iter().map(|&number| i64::from_le_bytes(number) as f64).collect()
    };
    (header, numbers)
}

/// An array of an archive, whose entries are not packed.
fn array(archive: &[u8], name: &str) -> Vec<f64> {
    let zip = ZipArchive::from_slice(archive).unwrap();
    let found = zip.entries().find_map(|entry| {
        let entry = entry.unwrap();
        (entry.file_path().as_ref() == name.as_bytes()).then(|| entry.wayfinder())
    });
    npy(zip.get_entry(found.unwrap()).unwrap().data()).1
}

#[test]
fn rows_are_the_distances_from_each_source() {
    let folder = folder("matrix_rows");
    fs::write(folder.join("sources.txt"), "5\n7:0.2,0.3,0.5\n@1.4,0,0\n").unwrap();
    fs::write(folder.join("targets.txt"), "200\n# none\n3\n").unwrap();
    let rows: Vec<Vec<f64>> = ["5", "7:0.2,0.3,0.5", "@1.4,0,0"]
        .map(|source| distances(&folder, &["torus.ply", "--exact", "--source", source]))
        .to_vec();
    let matrix = ["matrix", "torus.ply", "--sources", "sources.txt", "--method", "exact"];
    let told = json(&folder, &[&matrix[..], &["--output", "all.npy"]].concat());
    assert_eq!((&told["rows"], &told["columns"], &told["rows_before"]), (&3.into(), &288.into(), &0.into()));
    let (header, numbers) = npy(&fs::read(folder.join("all.npy")).unwrap());
    assert!(header.contains("'fortran_order': False, 'shape': (3, 288)"), "{header}");
    assert_eq!(numbers, rows.concat());

    let some = [&matrix[..], &["--targets", "targets.txt"]].concat();
    succeed(&folder, &[&some[..], &["--dtype", "f32", "--output", "some.npy"]].concat());
    let expected: Vec<f64> =
        rows.iter().flat_map(|row| [row[200], row[3]]).map(|value| f64::from(value as f32)).collect();
    assert_eq!(npy(&fs::read(folder.join("some.npy")).unwrap()).1, expected);
    let csv = succeed(&folder, &[&some[..], &["--output", "-"]].concat());
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "source,200,3");
    let numbers: Vec<f64> = lines[1].split(',').map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(numbers, [5.0, rows[0][200], rows[0][3]]);
    assert!(lines[2].starts_with("\"7:0.2,0.3,0.5\","), "{csv}");
}

#[test]
fn entries_beyond_the_largest_distance_are_left_out() {
    let folder = folder("matrix_sparse");
    let limited = ["matrix", "torus.ply", "--all", "--max-distance", "0.5", "--output"];
    succeed(&folder, &[&limited[..], &["dense.npy"]].concat());
    let (_, dense) = npy(&fs::read(folder.join("dense.npy")).unwrap());
    succeed(&folder, &[&limited[..], &["sparse.npz"]].concat());
    let archive = fs::read(folder.join("sparse.npz")).unwrap();
    let [columns, starts, shape, numbers] =
        ["indices.npy", "indptr.npy", "shape.npy", "data.npy"].map(|name| array(&archive, name));
    assert_eq!((shape, starts.len(), starts[288] as usize), (vec![288.0, 288.0], 289, numbers.len()));
    let mut again = vec![f64::INFINITY; 288 * 288];
    for row in 0..288 {
        for entry in starts[row] as usize..starts[row + 1] as usize {
            again[row * 288 + columns[entry] as usize] = numbers[entry];
        }
    }
    assert_eq!(again, dense);
    assert!(numbers.len() < 288 * 288 / 4 && numbers.iter().all(|&number| number <= 0.5));
    let csv = succeed(&folder, &[&limited[..], &["-"]].concat());
    assert_eq!(csv.lines().count(), numbers.len() + 1);
    assert_eq!(csv.lines().nth(1), Some("0,0,0.0000000000000000e0"));
    let unpacked = refused(&folder, &["matrix", "torus.ply", "--all", "--output", "all.npz"]);
    assert!(unpacked.contains("give --max-distance"), "{unpacked}");
}

#[test]
fn landmarks_are_those_of_sample_and_vertices_on_no_triangle_are_far() {
    let folder = folder("matrix_landmarks");
    let told = json(&folder, &["matrix", "torus.ply", "--landmarks", "9", "--output", "landmarks.npy"]);
    assert_eq!(told["landmarks"], json(&folder, &["sample", "torus.ply", "--count", "9"])["places"]);
    succeed(&folder, &["matrix", "two.obj", "--all", "--output", "two.npy"]);
    let (header, numbers) = npy(&fs::read(folder.join("two.npy")).unwrap());
    assert!(header.contains("(7, 7)"));
    let is_near = |row: usize, column: usize| row / 3 == column / 3 && row.max(column) < 6;
    for (entry, number) in numbers.iter().enumerate() {
        assert_eq!(number.is_finite(), is_near(entry / 7, entry % 7), "{entry}");
    }
}

#[test]
fn methods_and_any_number_of_threads_give_the_same_bytes() {
    let folder = folder("matrix_threads");
    for method in ["auto", "exact", "propagation", "heat"] {
        let written = ["1", "2", "5"].map(|threads| {
            let options = ["--method", method, "--threads", threads, "--output", "d.npy"];
            succeed(&folder, &[&["matrix", "torus.ply", "--landmarks", "100"], &options[..]].concat());
            fs::read(folder.join("d.npy")).unwrap()
        });
        assert!(written[0] == written[1] && written[1] == written[2], "{method}");
        let (_, numbers) = npy(&written[0]);
        let first = distances(&folder, &["torus.ply", "--source", "0", "--method", method]);
        assert_eq!(&numbers[..288], &first[..], "{method}");
    }
}

/// Runs to the end, and may tell on standard error how far it is; returns what it prints.
fn finished(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Begins a matrix and kills it as soon as a block of rows is finished.
fn killed(folder: &Path, arguments: &[&str], output: &str) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_heatwalk"));
    let mut process = command.current_dir(folder).args(arguments).stdout(Stdio::null()).spawn().unwrap();
    let log = folder.join(format!("{output}.part.log"));
    while fs::read_to_string(&log).map_or(0, |log| log.lines().count()) < 2 {
        assert!(process.try_wait().unwrap().is_none(), "it was to be killed in the middle");
        std::thread::sleep(Duration::from_millis(1));
    }
    process.kill().unwrap();
    process.wait().unwrap();
    assert!(!folder.join(output).exists() && folder.join(format!("{output}.part")).exists());
}

#[test]
fn a_killed_run_is_finished_by_the_next_to_the_last_bit() {
    let folder = folder("matrix_killed");
    fs::write(folder.join("large.ply"), write_torus()).unwrap();
    for (output, more) in [("d.npy", &[][..]), ("d.npz", &["--max-distance", "1.5"]), ("d.csv", &["--dtype", "f32"])] {
        let matrix = |file: &'static str, threads: &'static str| {
            let start = ["matrix", "large.ply", "--landmarks", "320", "--threads", threads, "--output", file];
            [&start[..], more].concat()
        };
        let undisturbed = if output == "d.npy" {
            "u.npy"
        } else if output == "d.npz" {
            "u.npz"
        } else {
            "u.csv"
        };
        finished(&folder, &matrix(undisturbed, "2"));
        let of = |file: &str| fs::read(folder.join(file)).unwrap();
        let _ = fs::remove_file(folder.join(output));
        let first = matrix(output, "1");
        killed(&folder, &first, output);

        // What was being written when it was killed does not count, nor does a line of the log without its end.
        let append = |name: String, bytes: &[u8]| {
            OpenOptions::new().append(true).open(folder.join(name)).unwrap().write_all(bytes).unwrap();
        };
        append(format!("{output}.part"), &[7; 1000]);
        append(format!("{output}.part.log"), b"99 123");
        // Another question is not what was begun.
        let other = refused(&folder, &[&first[..], &["--method", "propagation"]].concat());
        assert!(other.contains("begun with another mesh"), "{other}");

        let last = run(&folder, &matrix(output, "2"));
        let stderr = String::from_utf8(last.stderr).unwrap();
        assert!(last.status.success() && stderr.contains("rows were finished before"), "{stderr}");
        assert!(of(output) == of(undisturbed), "{output}");
        for rest in [".part", ".part.log"] {
            assert!(!folder.join(format!("{output}{rest}")).exists());
        }
    }
}

#[test]
fn a_damaged_block_is_found_again() {
    let folder = folder("matrix_damaged");
    fs::write(folder.join("large.ply"), write_torus()).unwrap();
    let matrix = ["matrix", "large.ply", "--landmarks", "320", "--threads", "1", "--output", "d.npy"];
    let _ = fs::remove_file(folder.join("d.npy"));
    killed(&folder, &matrix, "d.npy");
    let path = folder.join("d.npy.part");
    let mut bytes = fs::read(&path).unwrap();
    bytes[5000] ^= 1;
    fs::write(&path, bytes).unwrap();
    let told = finished(&folder, &[&matrix[..], &["--json"]].concat());
    assert!(told.contains("\"rows_before\":0,"), "{told}");
}

fn write_torus() -> Vec<u8> {
    let soup = heatwalk_shapes::torus(1.0, 0.4, 36, 18);
    heatwalk_model::io::write::distance_ply(&soup, &vec![0.0; soup.positions.len()])
}

/// A file may have no more than so many blocks: what a full disk does, without one.
#[cfg(unix)]
#[test]
fn a_full_disk_is_told_and_what_is_finished_is_kept() {
    let folder = folder("matrix_full");
    fs::write(folder.join("large.ply"), write_torus()).unwrap();
    let _ = fs::remove_file(folder.join("d.npy"));
    let matrix = ["matrix", "large.ply", "--landmarks", "320", "--threads", "1", "--output", "d.npy"];
    let limited = format!("trap '' XFSZ; ulimit -f 800; exec \"$0\" {}", matrix.join(" "));
    let mut shell = Command::new("sh");
    let output = shell.current_dir(&folder).args(["-c", &limited, env!("CARGO_BIN_EXE_heatwalk")]).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("of 320 rows are finished and kept") && stderr.contains("cannot write"), "{stderr}");
    assert!(!folder.join("d.npy").exists());
    let last = run(&folder, &matrix);
    assert!(String::from_utf8(last.stderr).unwrap().contains("rows were finished before"));
    finished(&folder, &[&matrix[..7], &["u.npy"]].concat());
    assert!(fs::read(folder.join("d.npy")).unwrap() == fs::read(folder.join("u.npy")).unwrap());
}

#[test]
fn bad_matrices_are_refused() {
    let folder = folder("matrix_refused");
    fs::write(folder.join("places.txt"), "3\n5:1,0,0\n").unwrap();
    for (arguments, hint) in [
        (&["torus.ply", "--output", "d.npy"][..], "--all"),
        (&["torus.ply", "--all"], "--output"),
        (&["torus.ply", "--all", "--landmarks", "3", "--output", "d.npy"], "cannot be used"),
        (&["torus.ply", "--landmarks", "0", "--output", "d.npy"], "at least 1"),
        (&["torus.ply", "--all", "--output", "d.mat"], ".csv, .npy or .npz"),
        (&["torus.ply", "--all", "--output", "no/such/d.npy"], "cannot write"),
        (&["torus.ply", "--all", "--dtype", "f16", "--output", "d.npy"], "f32, f64"),
        (&["torus.ply", "--all", "--max-distance", "1", "--method", "heat", "--output", "d.npy"], "no effect"),
        (&["torus.ply", "--all", "--targets", "places.txt", "--output", "d.npy"], "5:1,0,0 is no vertex"),
        (&["shape:cube", "--all", "--output", "d.npy"], "tetrahedra"),
    ] {
        let line = refused(&folder, &[&["matrix"], arguments].concat());
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
}
