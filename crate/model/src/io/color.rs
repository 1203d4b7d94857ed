//! Colors as displays take them.

/// The linear light of a channel, 0 to 1, in sRGB (IEC 61966-2-1).
pub fn light(share: f64) -> f64 {
    if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}
