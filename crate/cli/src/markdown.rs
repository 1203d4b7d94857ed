//! Tables in Markdown, aligned for plain reading.

/// Stands for a figure that there is not.
pub const MISSING: &str = "–";

/// A table whose first row is the header, as wide as the longest row. The first column is aligned left, the others
/// right.
pub fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let cell = |row: &[String], column: usize| {
        let text = row.get(column).map_or(MISSING, String::as_str);
        text.replace(char::is_control, " ").replace('|', "\\|")
    };
    let width = |column: usize| rows.iter().map(|row| cell(row, column).chars().count()).max().unwrap_or(0).max(2);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for (index, row) in rows.iter().enumerate() {
        text.push('|');
        for (column, &width) in widths.iter().enumerate() {
            let cell = cell(row, column);
            text += &if column == 0 { format!(" {cell:<width$} |") } else { format!(" {cell:>width$} |") };
        }
        text.push('\n');
        if index == 0 {
            text.push('|');
            for (column, &width) in widths.iter().enumerate() {
                let rule = "-".repeat(width + 1);
                text += &if column == 0 { format!("{rule}-|") } else { format!("{rule}:|") };
            }
            text.push('\n');
        }
    }
    text
}
