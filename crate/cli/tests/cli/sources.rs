//! Places, lines and several sources.

use std::fs;
use std::path::Path;

use crate::{difference, distances, flat, folder, json, refused, zeros};

/// The unit square in two triangles: one agrees with the other, and the same two with the second turned around.
fn squares(folder: &Path) {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    fs::write(folder.join("agree.obj"), format!("{corners}f 1 2 3\nf 1 3 4\n")).unwrap();
    fs::write(folder.join("turned.obj"), format!("{corners}f 1 2 3\nf 1 4 3\n")).unwrap();
    fs::write(folder.join("dropped.obj"), format!("{corners}f 1 1 2\nf 1 2 3\nf 3 2 1\nf 1 3 4\n")).unwrap();
}

#[test]
fn a_place_in_a_turned_triangle_keeps_its_weights() {
    let folder = folder("turned");
    squares(&folder);
    assert_eq!(json(&folder, &["info", "agree.obj"])["flipped_faces"], 0);
    assert_eq!(json(&folder, &["info", "turned.obj"])["flipped_faces"], 1);
    // Triangles 0 and 1 of one file are those of the other with their last two corners exchanged or not.
    for (agree, turned, [x, y]) in
        [("0:0.2,0.3,0.5", "0:0.2,0.3,0.5", [0.8, 0.5]), ("1:0.2,0.3,0.5", "1:0.2,0.5,0.3", [0.3, 0.8_f64])]
    {
        let of_agree = distances(&folder, &["agree.obj", "--near", "0", "--source", agree]);
        let of_turned = distances(&folder, &["turned.obj", "--near", "0", "--source", turned]);
        // The matrices are the same up to the order of sums.
        assert!(difference(&of_agree, &of_turned) < 1e-12, "{agree}: {of_agree:?} {of_turned:?}");
        let elsewhere = distances(&folder, &["agree.obj", "--near", "0", "--source", "0:0.2,0.5,0.3"]);
        assert!(difference(&of_agree, &elsewhere) > 1e-3);
        let straight = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[u, v]| (u - x).hypot(v - y));
        for (file, place) in [("agree.obj", agree), ("turned.obj", turned)] {
            let exact = distances(&folder, &[file, "--exact", "--source", place]);
            assert!(difference(&exact, &straight) < 1e-12, "{file} {place}: {exact:?}");
        }
    }
}

#[test]
fn vertices_and_triangles_count_as_in_the_file_whatever_parts_are_chosen() {
    let folder = folder("part_triangles");
    let near = ["two.obj", "--near", "0", "--t", "1", "--source"];
    let of_both = distances(&folder, &[&near[..], &["1:0.2,0.3,0.5"]].concat());
    assert!(of_both[..3].iter().all(|value| value.is_infinite()) && of_both[6].is_infinite(), "{of_both:?}");
    let of_far = distances(&folder, &[&near[..], &["1:0.2,0.3,0.5", "--part", "1"]].concat());
    assert!(difference(&of_both[3..6], &of_far[3..6]) < 1e-12, "{of_both:?} {of_far:?}");
    assert!(of_far[..3].iter().all(|value| value.is_infinite()) && of_far.len() == 7, "{of_far:?}");
    for (source, expected) in [("0", "vertex 0 is used by no triangle"), ("0:1,0,0", "in none of the chosen parts")] {
        let told = refused(&folder, &["distance", "two.obj", "--part", "1", "--source", source]);
        assert!(told.contains(expected), "{told}");
    }
}

#[test]
fn triangles_of_interleaved_groups_count_in_the_order_of_their_lines() {
    let folder = folder("interleaved");
    let mut obj: String = (0..8).map(|vertex| format!("v {} {} 0\n", vertex % 4, vertex / 4)).collect();
    for (group, face) in
        [("A", "1 2 6"), ("B", "1 6 5"), ("A", "2 3 7"), ("B", "2 7 6"), ("A", "3 4 8"), ("B", "3 8 7")]
    {
        obj += &format!("g {group}\nf {face}\n");
    }
    fs::write(folder.join("a.obj"), obj).unwrap();
    fs::write(folder.join("costs.csv"), "triangle,cost\n1,100\n").unwrap();
    fs::write(folder.join("walls.csv"), "1\n").unwrap();
    // The middle of the triangle of vertices 0, 5 and 4, which alone has vertex 4.
    let middle = "1:0.3333,0.3333,0.3334";
    for arguments in
        [&["a.obj", "--source", middle, "--exact"][..], &["a.obj", "--part", "1", "--source", middle, "--exact"]]
    {
        let found = distances(&folder, arguments);
        assert!((found[4] - 2.0_f64.sqrt() / 3.0).abs() < 1e-3, "{found:?}");
    }
    let dear = distances(&folder, &["a.obj", "--source", "0", "--weights", "costs.csv"]);
    assert!(dear[4] > 10.0 && dear[1] == 1.0, "{dear:?}");
    let walled = distances(&folder, &["a.obj", "--source", "0", "--walls", "walls.csv"]);
    assert!(walled[4].is_infinite() && walled[1] == 1.0, "{walled:?}");
}

#[test]
fn bad_places_are_refused() {
    let folder = folder("places");
    squares(&folder);
    for (place, hint) in [
        ("x", "such as 12"),
        ("", "such as 12"),
        ("1.5", "such as 12"),
        ("1:0.5,0.5", "three weights"),
        ("1:0.2,0.3,0.3,0.2", "a place in a triangle has three"),
        ("1:a,b,c", "three weights"),
        (":1,0,0", "three weights"),
        ("1:0.9,0.9,0.9", "face 1 with weights [0.9, 0.9, 0.9]"),
        ("3:1.5,-0.5,0", "must sum to 1"),
        ("3:nan,0.5,0.5", "must sum to 1"),
        ("4", "vertex 4 does not exist; there are 4"),
        ("4:1,0,0", "triangle 4 does not exist; there are 4"),
        ("0:1,0,0", "triangle 0 has no area"),
        ("2:1,0,0", "triangle 2 has no area or repeats an earlier one"),
        ("1@", "after @"),
        ("1@-0.5", "after @"),
        ("1@inf", "after @"),
        ("1@0.5@0.5", "after @"),
        ("x@0.5", "such as 12"),
    ] {
        let line = refused(&folder, &["distance", "dropped.obj", "--source", place]);
        assert!(line.contains(hint), "{place}: {line}");
    }
    for place in ["x", "4", "0:1,0,0", "1:0.5,0.5", "1@0.5"] {
        refused(&folder, &["path", "dropped.obj", "--from", place, "--to", "0"]);
        refused(&folder, &["path", "dropped.obj", "--from", "0", "--to", place]);
    }
}

#[test]
fn a_source_may_start_from_a_distance() {
    let folder = folder("offset");
    let of = |sources: &[&str]| distances(&folder, &[&["torus.ply", "--near", "0"], sources].concat());
    let plain = of(&["--source", "0"]);
    let shifted = of(&["--source", "0@0.5"]);
    assert_eq!(shifted[0], 0.5);
    let expected: Vec<f64> = plain.iter().map(|value| value + 0.5).collect();
    // One constant is added to a solve of the same system.
    assert!(difference(&shifted, &expected) < 1e-9);
    // A source that starts from more than its distance from another does not count.
    assert!(difference(&of(&["--source", "0", "--source", "150@100"]), &plain) < 1e-9);
    let both = of(&["--source", "0", "--source", "150@0.25"]);
    // Held by a constraint, up to the rounding of its solve.
    assert!(both[0] == 0.0 && (both[150] - 0.25).abs() < 1e-12, "{} {}", both[0], both[150]);
    let exact = distances(&folder, &["flat.ply", "--exact", "--source", "0@0.5", "--source", "80"]);
    let straight: Vec<f64> =
        flat().positions.iter().map(|at| (0.5 + at.x.hypot(at.z)).min((1.0 - at.x).hypot(1.0 + at.z))).collect();
    assert!(difference(&exact, &straight) < 1e-9, "{exact:?}");
}

#[test]
fn every_vertex_along_a_line_is_a_source() {
    let folder = folder("line");
    let of = |sources: &[&str]| zeros(&distances(&folder, &[&["flat.ply", "--near", "0"], sources].concat()));
    let side: Vec<usize> = (0..9).collect();
    assert_eq!(of(&["--line", "0,8"]), side);
    assert_eq!(of(&["--line", "0,3,8"]), side);
    assert_eq!(of(&["--line", "0,8", "--closed"]), side);
    let is_rim = |vertex: usize| [0, 8].contains(&(vertex / 9)) || [0, 8].contains(&(vertex % 9));
    let rim: Vec<usize> = (0..81).filter(|&vertex| is_rim(vertex)).collect();
    assert_eq!(of(&["--line", "0,8,80,72", "--closed"]), rim);
    // Without its fourth side.
    let open: Vec<usize> =
        rim.iter().copied().filter(|&vertex| vertex % 9 != 0 || vertex == 0 || vertex == 72).collect();
    assert_eq!(of(&["--line", "0,8,80,72"]), open);
    assert_eq!(of(&["--line", "0,8", "--line", "72,80"]).len(), 18);
    assert_eq!(of(&["--line", "0,8", "--source", "80"]), [side, vec![80]].concat());

    let exact = distances(&folder, &["flat.ply", "--exact", "--line", "0,8"]);
    let straight: Vec<f64> = flat().positions.iter().map(|at| at.x).collect();
    assert!(difference(&exact, &straight) < 1e-9, "{exact:?}");

    for (arguments, hint) in [
        (&["flat.ply", "--line", "0"][..], "two vertices"),
        (&["flat.ply", "--line", "0,x"], "two vertices"),
        (&["flat.ply", "--line", "0,81"], "vertex 81 does not exist"),
        (&["flat.ply", "--source", "0", "--closed"], "--line"),
        (&["two.obj", "--line", "0,6"], "no triangle"),
        (&["two.obj", "--line", "0,3"], "[0, 3]"),
    ] {
        let line = refused(&folder, &[&["distance"], arguments].concat());
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
}

#[test]
fn several_sources_are_exactly_zero_unless_summed() {
    let folder = folder("multi");
    let sources = ["flat.ply", "--near", "0", "--source", "0", "--source", "1", "--source", "80", "--multi"];
    let of = |multi| distances(&folder, &[&sources[..], &[multi]].concat());
    let (exact, summed) = (of("exact"), of("summed"));
    assert_eq!(zeros(&exact), [0, 1, 80]);
    // One constant cannot bring three sources that are not alike to 0 at once.
    assert!(difference(&exact, &summed) > 1e-3);
    let sources = &sources[..sources.len() - 1];
    assert!(difference(&distances(&folder, sources), &exact) == 0.0, "exact is the default");
    // The same place, named three ways, is one source.
    let same = ["flat.ply", "--near", "0", "--source", "0", "--source", "0", "--source", "0:1,0,0"];
    assert!(difference(&distances(&folder, &same), &distances(&folder, &same[..5])) < 1e-9);
}
