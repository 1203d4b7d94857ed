//! Filters (appendix B of the specification): what is left to do with attributes once their bytes are restored.

/// Normals and tangents in octahedral coordinates; the fourth component stays.
pub fn octahedral(bytes: &mut [u8], stride: usize) {
    each_four(bytes, stride, |[x, y, one, w], width| {
        let (x, y) = (signed(x, width) / signed(one, width), signed(y, width) / signed(one, width));
        let z = 1.0 - x.abs() - y.abs();
        // The lower half is folded over the upper one.
        let fold = z.min(0.0);
        let (x, y) = (x - fold.copysign(x), y - fold.copysign(y));
        let scale = largest_signed(width) / (x * x + y * y + z * z).sqrt();
        [whole(x * scale), whole(y * scale), whole(z * scale), w]
    });
}

/// Unit quaternions without their largest component.
pub fn quaternion(bytes: &mut [u8], stride: usize) {
    each_four(bytes, stride, |[x, y, z, last], width| {
        let scale = std::f32::consts::FRAC_1_SQRT_2 / signed(last | 3, width);
        let [x, y, z] = [x, y, z].map(|component| signed(component, width) * scale);
        let w = (1.0 - x * x - y * y - z * z).max(0.0).sqrt();
        let mut components = [w, x, y, z].map(|component| whole(component * largest_signed(width)));
        components.rotate_right((last & 3) as usize);
        components
    });
}

/// Numbers `mantissa · 2^exponent`, of 24 and 8 bits, as single precision.
pub fn exponential(bytes: &mut [u8], _stride: usize) {
    for four in bytes.as_chunks_mut::<4>().0 {
        let word = i32::from_le_bytes(*four);
        let value = f64::from(word << 8 >> 8) * 2.0_f64.powi(word >> 24);
        *four = (value as f32).to_le_bytes();
    }
}

/// Colors as luma, two chroma values and opacity; the highest bit of opacity tells their precision.
pub fn color(bytes: &mut [u8], stride: usize) {
    each_four(bytes, stride, |[y, co, cg, opacity], width| {
        let bits = u32::BITS - opacity.leading_zeros();
        let largest = (1_u32 << bits) - 1;
        let opacity = opacity & largest >> 1;
        let opacity = (opacity << 1 | opacity & 1) as f32;
        let (y, co, cg) = (y as f32, signed(co, width), signed(cg, width));
        let scale = ((1_u32 << width) - 1) as f32 / largest as f32;
        [y + co - cg, y + cg, y - co - cg, opacity].map(|component| whole(component * scale))
    });
}

/// Replaces the four components of each element, of 8 or 16 bits each by its stride. They are handed over without
/// their signs, with their width in bits.
fn each_four(bytes: &mut [u8], stride: usize, replace: impl Fn([u32; 4], u32) -> [u32; 4]) {
    if stride == 4 {
        for element in bytes.as_chunks_mut::<4>().0 {
            *element = replace(element.map(u32::from), 8).map(|component| component as u8);
        }
    } else {
        for element in bytes.as_chunks_mut::<8>().0 {
            let component = |i| u32::from(u16::from_le_bytes([element[2 * i], element[2 * i + 1]]));
            let components = replace(std::array::from_fn(component), 16);
            for (two, component) in element.as_chunks_mut::<2>().0.iter_mut().zip(components) {
                *two = (component as u16).to_le_bytes();
            }
        }
    }
}

/// The low `width` bits in two's complement.
fn signed(component: u32, width: u32) -> f32 {
    let unused = u32::BITS - width;
    ((component << unused) as i32 >> unused) as f32
}

fn largest_signed(width: u32) -> f32 {
    ((1_u32 << (width - 1)) - 1) as f32
}

/// The nearest integer, in two's complement.
fn whole(value: f32) -> u32 {
    value.round() as i32 as u32
}
