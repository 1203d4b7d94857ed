//! What moves the camera by itself: a smooth move to another view, and the glide after an orbit by pointer.

use glam::DVec2;

use super::view::View;

/// After the pointer lets go, the camera glides on and loses speed by a factor e in this time; seconds.
pub(super) const GLIDE_SECONDS: f64 = 0.18;
/// Time over which the pointer's speed is taken; seconds.
const POINTER_SECONDS: f64 = 0.04;
/// A slower glide is none; radians a second.
const LEAST_GLIDE: f64 = 0.02;
/// Length of a smooth move; seconds.
pub(super) const FLIGHT_SECONDS: f64 = 0.3;

/// A smooth move under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flight {
    from: View,
    to: View,
    seconds: f64,
}

impl Flight {
    pub(super) fn new(from: View, to: View) -> Self {
        Self { from, to, seconds: 0.0 }
    }

    /// The same with all distances times a factor.
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { from: self.from.scaled(factor), to: self.to.scaled(factor), ..self }
    }

    /// The view some seconds later, and whether it is the last.
    pub(super) fn advance(&mut self, seconds: f64) -> (View, bool) {
        self.seconds += seconds;
        let time = (self.seconds / FLIGHT_SECONDS).min(1.0);
        (View::between(self.from, self.to, time * time * (3.0 - 2.0 * time)), time >= 1.0)
    }
}

/// Orbiting by pointer: yaw and pitch, radians.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Orbit {
    /// True while the pointer holds on.
    is_held: bool,
    /// Since the last frame.
    turned: DVec2,
    /// A second.
    speed: DVec2,
}

impl Orbit {
    /// The pointer takes hold.
    pub(super) fn begin(&mut self) {
        *self = Self { is_held: true, ..Self::default() };
    }

    /// The pointer lets go; what follows is as fast as it was, or nothing.
    pub(super) fn end(&mut self, glides: bool) {
        let speed = if glides && self.is_held { self.speed } else { DVec2::ZERO };
        *self = Self { speed, ..Self::default() };
    }

    pub(super) fn is_held(&self) -> bool {
        self.is_held
    }

    /// Tells how far the pointer turned the camera.
    pub(super) fn follow(&mut self, turn: DVec2) {
        if self.is_held {
            self.turned += turn;
        }
    }

    /// Ends a glide.
    pub(super) fn rest(&mut self) {
        self.speed = DVec2::ZERO;
    }

    /// True while the camera glides or the pointer's speed is being taken.
    pub(super) fn is_moving(&self) -> bool {
        self.turned != DVec2::ZERO || self.speed.length() > LEAST_GLIDE
    }

    /// By how much the camera glides on.
    pub(super) fn advance(&mut self, seconds: f64) -> DVec2 {
        if self.is_held {
            if seconds > 0.0 {
                let share = 1.0 - (-seconds / POINTER_SECONDS).exp();
                self.speed = self.speed.lerp(self.turned / seconds, share);
                self.turned = DVec2::ZERO;
            }
        } else if self.speed.length() > LEAST_GLIDE {
            let kept = (-seconds / GLIDE_SECONDS).exp();
            let glide = GLIDE_SECONDS * (1.0 - kept) * self.speed;
            self.speed = kept * self.speed;
            return glide;
        }
        DVec2::ZERO
    }
}
