use std::fmt::Write as _;

use heatwalk::{
    AUTOMATIC, Boundary, Choice, DEFAULT_WINDOWS, EdgeKind, ExactRadius, FaceField, LinearSolver, MemoryLimit, Method,
    MultiSource, Operator, PathKind, Sign, Stage, TimeStep, Up, VertexField, WINDOWS,
};

use super::*;

/// What the module must say of a choice, by the solver's own values.
fn said<C: Choice + Default>(constant: &str) -> String {
    let quoted = |name: &str| format!("'{name}'");
    let names: Vec<String> = C::ALL.iter().map(|choice| quoted(choice.name())).collect();
    let former = |choice: &C| {
        let name = quoted(choice.name());
        choice.former_names().iter().map(move |former| format!("{}: {name}", quoted(former))).collect::<Vec<_>>()
    };
    let former: Vec<String> = C::ALL.iter().flat_map(former).collect();
    let mut text = format!("export const {constant}: Choice<");
    let _ = writeln!(text, "{}> = {{", std::any::type_name::<C>().rsplit("::").next().unwrap());
    let _ = write!(text, "  names: [{}],\n  default: '{}',\n  former: ", names.join(", "), C::default());
    text + &if former.is_empty() { "{},\n".to_owned() } else { format!("{{ {} }},\n", former.join(", ")) }
}

#[test]
fn the_page_has_the_names_and_ranges_of_the_solver() {
    let text = module(Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap()).unwrap();
    let choices = [
        said::<Boundary>("BOUNDARY"),
        said::<EdgeKind>("EDGE_KIND"),
        said::<FaceField>("FACE_FIELD"),
        said::<LinearSolver>("LINEAR_SOLVER"),
        said::<Method>("METHOD"),
        said::<MultiSource>("MULTI_SOURCE"),
        said::<Operator>("OPERATOR"),
        said::<PathKind>("PATH_KIND"),
        said::<Sign>("SIGN"),
        said::<Up>("UP"),
        said::<VertexField>("VERTEX_FIELD"),
    ];
    for choice in &choices {
        assert!(text.contains(choice), "{choice}\nis not in\n{text}");
    }
    assert_eq!(text.matches(": Choice<").count(), choices.len(), "every choice is compared");
    let stages = [
        Stage::Assembling,
        Stage::Ordering,
        Stage::Analysing,
        Stage::Factoring,
        Stage::Searching { radius: 0.0 },
        Stage::Answering,
        Stage::Filling,
    ];
    let stages = stages.map(|stage| format!("'{stage}'")).join(" | ");
    assert!(text.contains(&format!("export type Stage = {stages};")), "{stages}\nis not in\n{text}");
    for (constant, range) in [
        ("TIME_STEP_FACTORS", TimeStep::FACTORS),
        ("EXACT_RADIUS_EDGES", ExactRadius::EDGES),
        ("MEMORY_LIMIT_MEBIBYTES", MemoryLimit::MEBIBYTES),
    ] {
        let range = format!("export const {constant} = [{}, {}] as const;", range.start(), range.end());
        assert!(text.contains(&range), "{range}\nis not in\n{text}");
    }
    assert!(text.contains(&format!("export const AUTOMATIC = '{AUTOMATIC}';")), "{text}");
    assert!(text.contains(&format!("export const WINDOWS = {WINDOWS:?} as const;")), "{text}");
    assert!(text.contains(&format!("export const DEFAULT_WINDOWS = {DEFAULT_WINDOWS};")), "{text}");
    for line in [
        "SURFACE_EXTENSIONS = ['3mf', 'coff', 'gii', 'glb', 'gltf', 'inflated', 'noff', 'obj', 'off', 'orig', 'pial', 'ply', 'smoothwm', 'sphere', 'stl', 'vtk', 'vtp', 'vtu', 'white']",
        "POINT_EXTENSIONS = ['asc', 'csv', 'pts', 'txt', 'xyz']",
        "TETRAHEDRON_EXTENSIONS = ['ele', 'mesh', 'meshb', 'msh', 'node', 'vtk', 'vtu']",
    ] {
        assert!(text.contains(&format!("export const {line} as const;")), "{line}\nis not in\n{text}");
    }
}

#[test]
fn a_definition_of_another_form_is_refused() {
    let problem = |source: &str| Definitions::default().read(source).unwrap_err().to_string();
    assert!(problem("choice!(Kind, \"kind\": A = \"a\");").contains("Kind is no enum"));
    assert!(problem("enum Kind { A } choice!(Kind, \"kind\": A = \"a\");").contains("no default"));
    assert!(problem("enum Kind { #[default] A } choice!(Kind, \"kind\": B = \"b\");").contains("variants"));
    assert!(problem("pub struct Options { pub name: String }").contains("name is neither"));
}
