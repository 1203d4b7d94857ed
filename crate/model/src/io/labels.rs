//! Labels of the vertices of a brain: parcels of an atlas, of GIFTI (`.label.gii`) or FreeSurfer (`.annot`).

/// Names of labels by which programs say that a vertex has none.
const NO_NAMES: [&str; 3] = ["", "???", "unknown"];

/// What each vertex of a surface is called.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Labels {
    /// Names of labels, in the order of the file.
    pub names: Vec<String>,
    /// The label of each vertex, an index of `names`; none where the file names none.
    pub of_vertices: Vec<Option<u32>>,
}

impl Labels {
    /// Whether a file may hold labels, by its name.
    #[must_use]
    pub fn are_in(name: &str) -> bool {
        let name = name.to_ascii_lowercase();
        name.ends_with(".gii") || name.ends_with(".annot")
    }

    /// The vertices of a label, ascending.
    pub fn vertices(&self, label: usize) -> impl Iterator<Item = usize> + '_ {
        let has_label = move |(vertex, own): (usize, &Option<u32>)| (*own == Some(label as u32)).then_some(vertex);
        self.of_vertices.iter().enumerate().filter_map(has_label)
    }

    /// Whether a label is a parcel: one that does not say by its name that it is none, as `???` and `unknown` do.
    #[must_use]
    pub fn is_parcel(&self, label: usize) -> bool {
        !NO_NAMES.contains(&self.names[label].to_ascii_lowercase().as_str())
    }
}
