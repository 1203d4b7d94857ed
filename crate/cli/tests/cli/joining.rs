//! Links between components, and cracks.

use std::fs;

use serde_json::json as value;

use crate::{folder, json, refused, succeed};

#[test]
fn components_that_stay_apart_are_linked_on_demand() {
    let folder = folder("links");
    let apart = json(&folder, &["info", "two.obj"]);
    assert_eq!((&apart["groups"], &apart["links"]), (&value!(2), &value!([])));
    for links in ["1", "7", "all"] {
        let linked = json(&folder, &["info", "two.obj", "--link", links]);
        assert_eq!(linked["links"], value!([{ "components": [0, 1], "gap": 4.0 }]));
        assert_eq!((&linked["groups"], &linked["contacts"]), (&value!(1), &value!(0)));
    }
    let answer = json(&folder, &["distance", "two.obj", "--source", "0", "--link", "all", "--exact"]);
    // Along the legs of both triangles, and over the gap between them.
    assert_eq!((&answer["max_distance"], &answer["unreachable"]), (&value!(6.0), &value!(1)));
    let path = json(&folder, &["path", "two.obj", "--from", "4", "--to", "0", "--link", "all", "--exact"]);
    assert_eq!(path["length"], value!(6.0));
    let text = succeed(&folder, &["info", "two.obj", "--link", "1"]);
    assert!(text.contains("link 0                 components 0 and 1, gap 4.0\n"), "{text}");
    for links in ["-1", "none", "1.5"] {
        assert!(refused(&folder, &["info", "two.obj", "--link", links]).contains("link"));
    }
}

#[test]
fn cracks_are_welded_and_told_of() {
    let folder = folder("cracks");
    let patches = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1e-5\nv 1 1 0\nv 0 1 1e-5\nf 1 2 3\nf 4 5 6\n";
    fs::write(folder.join("patches.obj"), patches).unwrap();
    for (rule, vertices, components) in [("auto", 2, 1), ("1e-5", 2, 1), ("exact", 0, 2), ("9e-6", 0, 2)] {
        let answer = json(&folder, &["info", "patches.obj", "--weld", rule, "--bridge", "off"]);
        assert_eq!(
            (&answer["crack_vertices"], &answer["components"]),
            (&value!(vertices), &value!(components)),
            "{rule}"
        );
        assert_eq!(answer["crack_width"], value!(if vertices > 0 { 1e-5 } else { 0.0 }));
    }
    let across = json(&folder, &["distance", "patches.obj", "--source", "0", "--exact"]);
    assert!((across["max_distance"].as_f64().unwrap() - 2.0_f64.sqrt()).abs() < 1e-12, "{across}");
    assert!(refused(&folder, &["info", "patches.obj", "--weld", "-1"]).contains("the width of cracks to weld"));
}
