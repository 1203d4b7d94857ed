use encase::ShaderType;
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

/// How stripes lie on the material of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Blend {
    /// They cover it.
    #[default]
    Over,
    /// They cover it, white or black where they would not stand out.
    Contrast,
    /// Their colour is a factor on its.
    Multiply,
}

/// How the surface is coloured by its field. The colours are in the ramps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// From stripe to stripe, in the unit of the field's values; 0 for no pattern.
    pub period: f64,
    /// Moves the pattern away from the sources; periods.
    pub offset: f32,
    /// Stripes or lines.
    pub pattern: Pattern,
    /// Opacity of the stripes' own colour: 0 leaves the surface's.
    pub stripe_opacity: f32,
    /// Whether a surface whose file has materials is seen in these, and in the ramp's colours otherwise.
    pub has_materials_of_file: bool,
    /// How stripes lie on these.
    pub blend: Blend,
    /// Between the stripes.
    pub surface: Finish,
    /// On the stripes.
    pub stripe: Finish,
    /// Center and radius of the brush, whose outline is drawn; radius 0 for none.
    pub brush: Vec4,
}

impl Default for Style {
    fn default() -> Self {
        let finish = Finish { metalness: 0.0, roughness: 0.5, glow: 0.0 };
        let pattern = Pattern::Bands { width: 0.0, sharpness: 1.0, relief: 0.0 };
        Self {
            period: 0.0,
            offset: 0.0,
            pattern,
            stripe_opacity: 1.0,
            has_materials_of_file: false,
            blend: Blend::Over,
            surface: finish,
            stripe: finish,
            brush: Vec4::ZERO,
        }
    }
}

/// `Finish` of surface.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
struct FinishUniform {
    metalness: f32,
    roughness: f32,
    glow: f32,
}

/// `Style` of surface.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
pub(crate) struct StyleUniform {
    periods: f32,
    offset: f32,
    stripe_opacity: f32,
    multiplied: f32,
    contrasting: f32,
    line_half_width: f32,
    width: f32,
    flank: f32,
    relief: f32,
    // A struct inside a uniform starts at a multiple of 16 bytes.
    #[shader(align(16))]
    surface: FinishUniform,
    #[shader(align(16))]
    stripe: FinishUniform,
    #[shader(align(16))]
    brush: Vec4,
}

impl From<Finish> for FinishUniform {
    fn from(Finish { metalness, roughness, glow }: Finish) -> Self {
        Self { metalness, roughness, glow }
    }
}

impl Style {
    /// As surface.wgsl reads it, where the largest value of the field is `max`.
    pub(crate) fn uniform(&self, max: f64) -> StyleUniform {
        let mut uniform = StyleUniform {
            periods: 0.0,
            offset: self.offset,
            stripe_opacity: self.stripe_opacity,
            multiplied: if self.blend == Blend::Multiply { 1.0 } else { 0.0 },
            contrasting: if self.blend == Blend::Contrast { 1.0 } else { 0.0 },
            line_half_width: 0.0,
            width: 0.0,
            flank: LEAST_FLANK,
            relief: 0.0,
            surface: self.surface.into(),
            stripe: self.stripe.into(),
            brush: self.brush,
        };
        // With no period there is no pattern, and where no value is above 0 there is one phase.
        if self.period > 0.0 {
            uniform.periods = (max / self.period) as f32;
            match self.pattern {
                Pattern::Bands { width, sharpness, relief } => {
                    let width = width.clamp(0.0, 1.0);
                    let widest = 0.5 * width.min(1.0 - width);
                    uniform.flank = (widest * (1.0 - sharpness.clamp(0.0, 1.0))).max(LEAST_FLANK);
                    uniform.width = width;
                    uniform.relief = relief;
                }
                Pattern::Lines { width } => uniform.line_half_width = 0.5 * width.max(0.0),
            }
        }
        uniform
    }
}
