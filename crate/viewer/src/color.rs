use glam::Vec3;

/// sRGB in 0..1 to linear light (IEC 61966-2-1).
pub(crate) fn linear_from_srgb(color: Vec3) -> Vec3 {
    let channel = |value: f32| if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
    Vec3::new(channel(color.x), channel(color.y), channel(color.z))
}
