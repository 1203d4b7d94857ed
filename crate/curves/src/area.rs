//! How much of a surface is nearer than a value.

use heatwalk_base::sort;
use heatwalk_surface::triangle;

use crate::field::Field;
use crate::levels::Levels;

/// For each level the area of what is nearer, in the square of the field's unit. Triangles with an infinite distance are
/// left out.
pub fn enclosed(field: &Field, levels: &Levels) -> Vec<f64> {
    let values = levels.values();
    // What each level has more than the one before of triangles that are nearer as a whole, and what it has of others.
    let (mut whole, mut parts) = (vec![0.0; values.len()], vec![0.0; values.len()]);
    for index in 0..field.triangles().len() {
        let Some(mut distances) = field.corner_distances(index) else { continue };
        let area = 0.5 * triangle::length(triangle::area_vector(field.corners(index)));
        sort::sort_by(&mut distances, f64::total_cmp);
        let first = values.partition_point(|&value| value <= distances[0]);
        let end = values.partition_point(|&value| value < distances[2]);
        for level in first..end {
            parts[level] += area * share_below(distances, values[level]);
        }
        // All of a triangle of one distance is nearer than larger values only.
        if let Some(sum) = whole.get_mut(first.max(end)) {
            *sum += area;
        }
    }
    let mut sum = 0.0;
    whole
        .iter()
        .zip(&parts)
        .map(|(more, part)| {
            sum += more;
            sum + part
        })
        .collect()
}

/// The share of a triangle that is below a value between its least and its largest, both excluded; corners are ascending.
fn share_below([low, middle, high]: [f64; 3], value: f64) -> f64 {
    if value <= middle {
        (value - low) / (middle - low) * ((value - low) / (high - low))
    } else {
        1.0 - (high - value) / (high - middle) * ((high - value) / (high - low))
    }
}
