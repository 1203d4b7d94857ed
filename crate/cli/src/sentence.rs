//! Errors in one sentence, with what a user of the program can do about them.

use std::io::{self, ErrorKind};

use anyhow::Error;

/// The code of an error after which nothing more can be written.
pub const DISK_FULL: &str = "disk-full";

/// All that is known of an error. Libraries say what is wrong; what helps depends on who asks.
pub fn sentence(error: &Error) -> String {
    match code(error).and_then(remedy) {
        Some(remedy) => format!("{error:#}; {remedy}"),
        None => format!("{error:#}"),
    }
}

/// What kind of error it is.
pub fn code_of(error: &Error) -> &'static str {
    let of_system = || {
        let kind = error.chain().find_map(|cause| cause.downcast_ref::<io::Error>()).map(io::Error::kind)?;
        Some(if kind == ErrorKind::StorageFull { DISK_FULL } else { "file-system" })
    };
    code(error).or_else(of_system).unwrap_or("invalid-argument")
}

fn code(error: &Error) -> Option<&'static str> {
    let solver = error.chain().find_map(|cause| {
        let volume = || cause.downcast_ref::<heatwalk_volume::Error>().map(heatwalk_volume::Error::code);
        let index = || cause.downcast_ref::<heatwalk_index::Error>().map(heatwalk_index::Error::code);
        cause.downcast_ref::<heatwalk::Error>().map(heatwalk::Error::code).or_else(volume).or_else(index)
    });
    solver.or_else(|| heatwalk_files::code(error))
}

fn remedy(code: &str) -> Option<&'static str> {
    match code {
        "out-of-memory" => Some("use a mesh with fewer triangles, or a larger machine"),
        "too-large" => Some("or use a larger machine"),
        "missing-resource" => Some("put it beside the mesh"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use anyhow::Context;

    use super::sentence;

    #[test]
    fn a_remedy_follows_the_whole_sentence() {
        let missing = heatwalk_model::Error::MissingResource { uri: "a.bin".to_owned() };
        let inner = Err::<(), _>(missing).context("m.gltf").unwrap_err();
        assert_eq!(sentence(&inner), "m.gltf: the file refers to a.bin, which was not given; put it beside the mesh");
        let nested = heatwalk::Error::Surface(heatwalk::surface::Error::OutOfMemory { stage: "building" });
        assert!(sentence(&nested.into()).ends_with("or a larger machine"));
        assert_eq!(sentence(&heatwalk::Error::NoSource.into()), heatwalk::Error::NoSource.to_string());
    }
}
