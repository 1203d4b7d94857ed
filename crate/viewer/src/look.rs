use glam::Vec4;

/// Texels across one of the two ramps.
pub const RAMP_SIZE: usize = 256;

/// The narrowest flank of a stripe, in periods: a step would have no slope to light.
const LEAST_FLANK: f32 = 1e-3;

/// What light makes of a material, beside its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Finish {
    /// 0 is a dielectric, 1 a metal.
    pub metalness: f32,
    /// 0 is a mirror, 1 is matt.
    pub roughness: f32,
    /// Light given off, as a factor on the colour.
    pub glow: f32,
}

/// How distance is drawn upon the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pattern {
    /// Stripes that cover a share of the period.
    Bands {
        /// Share of the period, 0..1.
        width: f32,
        /// 0 fades over the whole stripe, 1 has hard edges.
        sharpness: f32,
        /// Height of the stripes over the ground between them, in periods; negative for grooves.
        relief: f32,
    },
    /// Thin lines at multiples of the period, and thinner ones at fifths of it.
    Lines {
        /// CSS pixels across.
        width: f32,
    },
}

/// How the surface is painted. The colours are in the ramps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// From stripe to stripe; world units. 0 for no pattern.
    pub period: f32,
    /// Moves the pattern away from the sources; periods.
    pub offset: f32,
    /// Stripes or lines.
    pub pattern: Pattern,
    /// Share of the stripes' own colour: 0 leaves the surface's.
    pub paint: f32,
    /// Between the stripes.
    pub surface: Finish,
    /// On the stripes.
    pub stripe: Finish,
}

impl Default for Look {
    fn default() -> Self {
        let finish = Finish { metalness: 0.0, roughness: 0.5, glow: 0.0 };
        let pattern = Pattern::Bands { width: 0.0, sharpness: 1.0, relief: 0.0 };
        Self { period: 0.0, offset: 0.0, pattern, paint: 1.0, surface: finish, stripe: finish }
    }
}

/// Vec4s of a look; see `Look` in surface.wgsl.
pub(crate) const LOOK_VECTORS: usize = 4;

impl Look {
    /// As surface.wgsl reads it; `max` is the distance at the ramps' end, in world units.
    pub(crate) fn vectors(&self, max: f32) -> [Vec4; LOOK_VECTORS] {
        let reciprocal = |value: f32| if value > 0.0 { value.recip() } else { 0.0 };
        let shape = match self.pattern {
            _ if self.period <= 0.0 => Vec4::new(0.0, LEAST_FLANK, 0.0, 0.0),
            Pattern::Bands { width, sharpness, relief } => {
                let width = width.clamp(0.0, 1.0);
                let widest = 0.5 * width.min(1.0 - width);
                let flank = (widest * (1.0 - sharpness.clamp(0.0, 1.0))).max(LEAST_FLANK);
                Vec4::new(width, flank, relief, 0.0)
            }
            Pattern::Lines { width } => Vec4::new(0.0, LEAST_FLANK, 0.0, 0.5 * width.max(0.0)),
        };
        let finish = |finish: Finish, last: f32| Vec4::new(finish.metalness, finish.roughness, finish.glow, last);
        [
            Vec4::new(reciprocal(self.period), reciprocal(max), self.offset, self.paint),
            shape,
            finish(self.surface, 0.0),
            finish(self.stripe, 0.0),
        ]
    }
}
