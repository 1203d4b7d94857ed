//! Points as lines of text, as scanners and tables have them.

use glam::DVec3;
use heatwalk_model::io::text;
use heatwalk_model::{Error, Result};

/// Extensions of such files, in lower case.
pub const EXTENSIONS: [&str; 5] = ["xyz", "txt", "csv", "asc", "pts"];

/// What the length of a normal of few digits may be off by.
const LENGTH_ROUNDING: f64 = 0.02;

/// Whether the extension of a name is that of such a file.
pub fn names_points(name: &str) -> bool {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    extension.is_some_and(|extension| EXTENSIONS.contains(&extension.as_str()))
}

/// Points, and normals of the surface there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Points {
    /// `#P × 3`.
    pub positions: Vec<DVec3>,
    /// `#P × 3`, of any length; empty where the text has none.
    pub normals: Vec<DVec3>,
}

/// The points of text: a line each, its first three numbers, or those below the names `x`, `y` and `z` of a first line. Words are parted by
/// white space, commas or semicolons; what is behind `#` or `//` is a comment, a first line of one number how many points there are.
/// Normals are below the names `nx`, `ny` and `nz` or, where no line names columns, the three numbers behind, if these have the length of
/// unit vectors on all lines. Further columns, such as colors, are not read.
///
/// # Errors
/// [`Error::Malformed`] for a line with less than three numbers; [`Error::Surface`] with `Empty` where there are no points.
pub fn read_points(name: &str, bytes: &[u8]) -> Result<Points> {
    let bytes = text::decoded(bytes)?;
    let content = String::from_utf8_lossy(bytes);
    let mut points = Points::default();
    let mut columns = [0, 1, 2];
    let mut normal_columns = Some([3, 4, 5]);
    let mut is_named = false;
    let mut is_first = true;
    for (number, line) in text::lines(&content) {
        let line = text::statement(line.split("//").next().unwrap_or_default());
        let words: Vec<&str> =
            line.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|word| !word.is_empty()).collect();
        if words.is_empty() {
            continue;
        }
        if std::mem::take(&mut is_first) {
            match (named(["x", "y", "z"], &words), &words[..]) {
                (Some(axes), _) => {
                    columns = axes;
                    normal_columns = named(["nx", "ny", "nz"], &words);
                    is_named = true;
                    continue;
                }
                (_, [count]) if count.parse::<usize>().is_ok() => continue,
                _ => {}
            }
        }
        let mut point = [0.0; 3];
        for (coordinate, column) in point.iter_mut().zip(columns) {
            let word = words.get(column).copied();
            *coordinate = word.and_then(text::number).ok_or_else(|| Error::Malformed {
                format: "points",
                place: format!("line {number}"),
                problem: format!("a point needs three numbers, but {}", text::why_no_number(word)),
            })?;
        }
        points.positions.push(DVec3::from(point));
        // Where one line has none, none has.
        let normal = normal_columns.and_then(|columns| normal_in(&words, columns));
        normal_columns = normal_columns.filter(|_| normal.is_some_and(|normal| is_named || is_unit(normal)));
        points.normals.extend(normal);
    }
    if normal_columns.is_none() {
        points.normals.clear();
    }
    if points.positions.is_empty() {
        let reason = format!("{name} is empty: nothing is in it; save or copy it again");
        return Err(heatwalk_surface::Error::Empty { reason }.into());
    }
    Ok(points)
}

/// The columns of these names, as CloudCompare and others write them: `x`, `X`, `"x"`, `//X`.
fn named(names: [&str; 3], words: &[&str]) -> Option<[usize; 3]> {
    let is = |word: &&str, name: &str| word.trim_matches(['"', '\'']).eq_ignore_ascii_case(name);
    let found = names.map(|name| words.iter().position(|word| is(word, name)));
    let [Some(x), Some(y), Some(z)] = found else { return None };
    Some([x, y, z])
}

fn normal_in(words: &[&str], columns: [usize; 3]) -> Option<DVec3> {
    let [x, y, z] = columns.map(|column| words.get(column).copied().and_then(text::number));
    Some(DVec3::new(x?, y?, z?))
}

/// Of what is written with few digits.
fn is_unit(normal: DVec3) -> bool {
    (normal.length() - 1.0).abs() < LENGTH_ROUNDING
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Vec<[f64; 3]> {
        read_points("a.xyz", text.as_bytes()).expect("points").positions.iter().map(DVec3::to_array).collect()
    }

    #[test]
    fn lines_are_points_however_their_numbers_are_parted() {
        let two = vec![[1.0, 2.0, 3.0], [-0.5, 4e2, 6.0]];
        for text in [
            "1 2 3\n-0.5 4e2 6\n",
            "# scan\n\n1,2,3,0,0,1\r\n-0.5, 4e2, 6, 0, 0, 1",
            "2\n1\t2\t3 255 0 0\n-.5\t400\t6 0 0 0\n",
            "1;2;3 // first\n-0.5;400;6",
            "\"X\",Y,Z,i\n1,2,3,9\n-0.5,400,6,9\n",
            "i x y z\n9 1 2 3\n9 -0.5 400 6\n",
        ] {
            assert_eq!(points(text), two, "{text}");
        }
        assert!(points("nan nan nan\n")[0][0].is_nan());
    }

    #[test]
    fn normals_are_named_or_of_unit_length_on_all_lines() {
        let normals = |text: &str| {
            let points = read_points("a.xyz", text.as_bytes()).expect("points");
            points.normals.iter().map(DVec3::to_array).collect::<Vec<_>>()
        };
        let two = vec![[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]];
        assert_eq!(normals("1 2 3 0 0 1\n4 5 6 0.6 0 -0.8\n"), two);
        assert_eq!(normals("nz,x,y,z,nx,ny\n1,1,2,3,0,0\n-0.8,4,5,6,0.6,0\n"), two);
        // Named ones may be of any length.
        assert_eq!(normals("x y z nx ny nz\n1 2 3 0 0 9\n4 5 6 0 0 0\n"), [[0.0, 0.0, 9.0], [0.0; 3]]);
        for colors in
            ["1 2 3 0 0 1\n4 5 6 1 1 1\n", "1 2 3 255 0 0\n", "1 2 3 0 0 1\n4 5 6\n", "1 2 3 0 0 1 \n4 5 6 nan 0 0\n"]
        {
            assert!(normals(colors).is_empty(), "{colors}");
        }
        assert!(normals("x y z r g b\n1 2 3 0 0 1\n").is_empty());
    }

    #[test]
    fn what_is_no_point_is_named_by_its_line() {
        let refused = |text: &str| read_points("a.xyz", text.as_bytes()).expect_err(text).to_string();
        assert!(refused("1 2 3\n4 5\n").contains("line 2: a point needs three numbers, but it is missing"));
        assert!(refused("1 2 3\n4 5 six\n").contains("\"six\" is found"));
        assert!(refused("").contains("a.xyz is empty"));
        assert!(refused("# nothing\n").contains("a.xyz is empty"));
        assert!(refused("name\n1 2 3\n").contains("line 1"));
    }
}
