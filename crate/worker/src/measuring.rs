//! What the page gets of measured legs and of closed curves.

use heatwalk::Enclosed;
use heatwalk_bindings::Message;

/// A path between two places, as places of the drawing, so that it can be drawn in any pose.
#[derive(Message)]
pub struct Leg {
    /// `#P`, drawn triangles that the points lie on: those that the path goes through after each.
    pub triangles: Vec<u32>,
    /// `#P × 3`, barycentric weights in them.
    pub weights: Vec<f64>,
    /// In the unit of the file.
    pub length: f64,
    /// Of the straight line between both ends, in the unit of the file.
    pub straight: f64,
    /// What it costs to walk; the length where all costs are 1.
    pub cost: f64,
}

/// What a closed curve encloses.
#[derive(Message)]
pub struct Enclosure {
    /// Whether there are two sides; else why not.
    #[typescript("'sides' | 'whole' | 'crossed' | 'sideless'")]
    pub kind: &'static str,
    /// The area of the smaller side, in the unit of the file squared; 0 where there is none.
    pub area: f64,
}

impl From<Enclosed> for Enclosure {
    fn from(enclosed: Enclosed) -> Self {
        let (kind, area) = match enclosed {
            Enclosed::Sides([left, right]) => ("sides", left.min(right)),
            Enclosed::Whole => ("whole", 0.0),
            Enclosed::Crossed => ("crossed", 0.0),
            Enclosed::Sideless => ("sideless", 0.0),
        };
        Self { kind, area }
    }
}
