//! Points as lines of text, as scanners and tables have them.

use glam::DVec3;
use heatwalk_model::io::text;
use heatwalk_model::{Error, Result};

/// Extensions of such files, in lower case.
pub const EXTENSIONS: [&str; 5] = ["xyz", "txt", "csv", "asc", "pts"];

/// Whether the extension of a name is that of such a file.
pub fn names_points(name: &str) -> bool {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    extension.is_some_and(|extension| EXTENSIONS.contains(&extension.as_str()))
}

/// The points of text: a line each, its first three numbers, or those below the names `x`, `y` and `z` of a first line. Words are parted by
/// white space, commas or semicolons; what is behind `#` or `//` is a comment, a first line of one number how many points there are.
/// Further columns, such as normals and colors, are not read.
///
/// # Errors
/// [`Error::Malformed`] for a line with less than three numbers; [`Error::Surface`] with `Empty` where there are no points.
pub fn read_points(name: &str, bytes: &[u8]) -> Result<Vec<DVec3>> {
    let bytes = text::decoded(bytes)?;
    let content = String::from_utf8_lossy(bytes);
    let mut points = Vec::new();
    let mut columns = [0, 1, 2];
    let mut is_first = true;
    for (number, line) in text::lines(&content) {
        let line = text::statement(line.split("//").next().unwrap_or_default());
        let words: Vec<&str> =
            line.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|word| !word.is_empty()).collect();
        if words.is_empty() {
            continue;
        }
        if std::mem::take(&mut is_first) {
            let named = ["x", "y", "z"].map(|axis| words.iter().position(|word| is_axis(word, axis)));
            match (named, &words[..]) {
                ([Some(x), Some(y), Some(z)], _) => {
                    columns = [x, y, z];
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
        points.push(DVec3::from(point));
    }
    if points.is_empty() {
        let reason = format!("{name} is empty: nothing is in it; save or copy it again");
        return Err(heatwalk_surface::Error::Empty { reason }.into());
    }
    Ok(points)
}

/// As CloudCompare and others name columns: `x`, `X`, `"x"`, `//X`.
fn is_axis(word: &str, axis: &str) -> bool {
    word.trim_matches(['"', '\'']).eq_ignore_ascii_case(axis)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(text: &str) -> Vec<[f64; 3]> {
        read_points("a.xyz", text.as_bytes()).expect("points").iter().map(DVec3::to_array).collect()
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
    fn what_is_no_point_is_named_by_its_line() {
        let refused = |text: &str| read_points("a.xyz", text.as_bytes()).expect_err(text).to_string();
        assert!(refused("1 2 3\n4 5\n").contains("line 2: a point needs three numbers, but it is missing"));
        assert!(refused("1 2 3\n4 5 six\n").contains("\"six\" is found"));
        assert!(refused("").contains("a.xyz is empty"));
        assert!(refused("# nothing\n").contains("a.xyz is empty"));
        assert!(refused("name\n1 2 3\n").contains("line 1"));
    }
}
