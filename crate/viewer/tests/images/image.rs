//! Small pictures, as files and against one another.

use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, BufWriter};
use std::path::Path;

/// Pixels.
pub const WIDTH: u32 = 240;
pub const HEIGHT: u32 = 180;

/// A channel that differs by more than this differs clearly; of 255.
const CLEARLY: u8 = 32;
/// Versions of the software device round differently, so contours fall on other samples: a pixel along them differs where a
/// sample is on the other side, by up to all there is. On one machine no pixel differs. The smallest thing that a test must
/// see missing, the walker, covers more than a hundred.
const CLEARLY_DIFFERENT_PIXELS: usize = 40;
/// The same of the whole picture: rounding of colours is less than one step, and contours are a hundredth of the pixels.
const MEAN_DIFFERENCE: f64 = 0.3;

/// `HEIGHT` rows of `WIDTH` RGB pixels.
pub struct Image(Vec<[u8; 3]>);

/// How far two images are apart.
pub struct Difference {
    /// Those that differ clearly.
    pub pixels: usize,
    /// Of all channels; of 255.
    pub mean: f64,
}

impl Image {
    /// Of opaque RGBA bytes.
    pub fn of(pixels: &[u8]) -> Self {
        Self(pixels.as_chunks::<4>().0.iter().map(|&[red, green, blue, _]| [red, green, blue]).collect())
    }

    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        self.0[(y * WIDTH + x) as usize]
    }

    pub fn read(path: &Path) -> io::Result<Self> {
        let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
        let mut pixels = vec![[0; 3]; (WIDTH * HEIGHT) as usize];
        reader.next_frame(pixels.as_flattened_mut())?;
        Ok(Self(pixels))
    }

    pub fn write(&self, path: &Path) -> io::Result<()> {
        let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), WIDTH, HEIGHT);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        encoder.write_header()?.write_image_data(self.0.as_flattened())?;
        Ok(())
    }

    pub fn difference(&self, other: &Self) -> Difference {
        let apart = |(a, b): (&[u8; 3], &[u8; 3])| [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]));
        let all = || self.0.iter().zip(&other.0).map(apart);
        let sum: u64 = all().flatten().map(u64::from).sum();
        Difference {
            pixels: all().filter(|channels| channels.iter().any(|&channel| channel > CLEARLY)).count(),
            mean: sum as f64 / (3 * self.0.len()) as f64,
        }
    }
}

impl Difference {
    pub fn is_small(&self) -> bool {
        self.pixels <= CLEARLY_DIFFERENT_PIXELS && self.mean <= MEAN_DIFFERENCE
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} pixels differ clearly, {:.2} in the mean", self.pixels, self.mean)
    }
}
