//! Arrays of NumPy to and from lists of numbers.

use glam::DVec3;
use numpy::{
    PyArray1, PyArray2, PyArrayDescrMethods, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;

use crate::errors::{Failure, Result};

/// Kinds of NumPy's types.
const SIGNED: u8 = b'i';
const UNSIGNED: u8 = b'u';
const FLOAT: u8 = b'f';

/// What a caller gives as an array.
pub struct Given<'py> {
    /// As messages call it.
    name: &'static str,
    array: Bound<'py, PyUntypedArray>,
}

impl<'py> Given<'py> {
    /// Of an array, or what NumPy makes one of.
    pub fn new(name: &'static str, value: &Bound<'py, PyAny>) -> Result<Self> {
        static AS_ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
        let array = AS_ARRAY.import(value.py(), "numpy", "asarray")?.call1((value,)).map_err(|error| {
            let reason = error.value(value.py()).to_string();
            Failure::new("bad-shape", format!("{name} is no array: {}", reason.lines().next().unwrap_or_default()))
        })?;
        Ok(Self { name, array: array.cast_into::<PyUntypedArray>().map_err(PyErr::from)? })
    }

    /// How many dimensions it has.
    pub fn dimensions(&self) -> usize {
        self.array.ndim()
    }

    /// Whether its numbers are whole by their type.
    pub fn is_whole(&self) -> bool {
        matches!(self.kind(), SIGNED | UNSIGNED)
    }

    /// Whether its numbers are floating by their type.
    pub fn is_float(&self) -> bool {
        self.kind() == FLOAT
    }

    fn kind(&self) -> u8 {
        self.array.dtype().kind()
    }

    /// `n × 3`, finite or not.
    pub fn points(&self) -> Result<Vec<DVec3>> {
        let numbers = self.rows_of(3, "(n, 3)", "float64 or float32")?.floats()?;
        Ok(numbers.chunks_exact(3).map(DVec3::from_slice).collect())
    }

    /// `m × 3` vertices, each less than `vertices`.
    pub fn triangles(&self, vertices: usize) -> Result<Vec<[u32; 3]>> {
        self.elements(|place, vertex| {
            if vertex < vertices as u64 {
                Ok(())
            } else {
                Err(heatwalk::surface::Error::IndexOutOfRange { triangle: place, vertex, vertices }.into())
            }
        })
    }

    /// `m × 4` vertices, each less than `vertices`.
    pub fn tetrahedra(&self, vertices: usize) -> Result<Vec<[u32; 4]>> {
        self.elements(|tetrahedron, vertex| {
            if vertex < vertices as u64 {
                return Ok(());
            }
            let vertex = u32::try_from(vertex).unwrap_or(u32::MAX);
            Err(heatwalk_volume::Error::IndexOutOfRange { tetrahedron, vertex, vertices }.into())
        })
    }

    /// `m × N` vertices, each of which is checked, with the number of its row.
    fn elements<const N: usize>(&self, check: impl Fn(usize, u64) -> Result<()>) -> Result<Vec<[u32; N]>> {
        let indices = self.rows_of(N, &format!("(m, {N})"), "integer")?.indices()?;
        indices.iter().enumerate().try_for_each(|(place, &vertex)| check(place / N, vertex))?;
        Ok(indices.as_chunks::<N>().0.iter().map(|corners| corners.map(|vertex| vertex as u32)).collect())
    }

    /// `k × width`.
    pub fn rows(&self, width: usize) -> Result<&Self> {
        self.rows_of(width, &format!("(k, {width})"), "float64 or float32")
    }

    fn rows_of(&self, width: usize, shape: &str, kind: &str) -> Result<&Self> {
        match self.array.shape() {
            [_, own] if *own == width => Ok(self),
            shape_given => Err(Failure::new(
                "bad-shape",
                format!("{} has the shape {shape_given:?}; give {kind} numbers of the shape {shape}", self.name),
            )),
        }
    }

    /// Of one dimension and this length, if one is given.
    pub fn row(&self, length: Option<usize>) -> Result<&Self> {
        match self.array.shape() {
            &[own] if length.is_none_or(|length| own == length) => Ok(self),
            shape => {
                let wanted = length.map_or_else(|| "(n,)".to_owned(), |length| format!("({length},)"));
                let sentence = format!("{} has the shape {shape:?}; give {wanted}", self.name);
                Err(Failure::new("bad-shape", sentence))
            }
        }
    }

    /// All of its numbers, row by row.
    pub fn floats(&self) -> Result<Vec<f64>> {
        match self.kind() {
            FLOAT | SIGNED | UNSIGNED => self.as_type("float64"),
            _ => Err(self.bad_type("float64 or float32 numbers")),
        }
    }

    /// All of its numbers, row by row, none of which may be negative.
    pub fn indices(&self) -> Result<Vec<u64>> {
        match self.kind() {
            UNSIGNED => self.as_type("uint64"),
            SIGNED => {
                let numbers: Vec<i64> = self.as_type("int64")?;
                let index = |number: i64| {
                    let sentence = || format!("{} holds {number}; indices count from 0", self.name);
                    u64::try_from(number).map_err(|_| Failure::new("negative-index", sentence()))
                };
                numbers.into_iter().map(index).collect()
            }
            // An empty list has numbers of no kind in particular.
            FLOAT if self.array.is_empty() => Ok(Vec::new()),
            _ => Err(self.bad_type("integers")),
        }
    }

    /// All of its numbers, whole, row by row.
    pub fn whole(&self) -> Result<Vec<i64>> {
        if self.is_whole() { self.as_type("int64") } else { Err(self.bad_type("integers")) }
    }

    fn as_type<T: numpy::Element + Copy>(&self, name: &str) -> Result<Vec<T>> {
        let array = self.array.call_method1("astype", (name, "C"))?;
        let array: PyReadonlyArrayDyn<'_, T> = array.extract().map_err(Failure::from)?;
        Ok(array.as_slice().map_err(PyErr::from)?.to_vec())
    }

    fn bad_type(&self, wanted: &str) -> Failure {
        let kind = self.array.dtype().to_string();
        Failure::new("bad-dtype", format!("{} has the dtype {kind}; give {wanted}", self.name))
    }
}

/// `n × 3`.
pub fn vectors<'py>(py: Python<'py>, points: impl ExactSizeIterator<Item = [f64; 3]>) -> Bound<'py, PyArray2<f64>> {
    rows(py, points)
}

/// `n × N`.
pub fn rows<'py, T: numpy::Element, const N: usize>(
    py: Python<'py>,
    rows: impl ExactSizeIterator<Item = [T; N]>,
) -> Bound<'py, PyArray2<T>> {
    let count = rows.len();
    let numbers: Vec<T> = rows.flatten().collect();
    shaped(py, numbers, [count, N])
}

/// Numbers row by row as a matrix.
pub fn shaped<T: numpy::Element>(py: Python<'_>, numbers: Vec<T>, shape: [usize; 2]) -> Bound<'_, PyArray2<T>> {
    PyArray1::from_vec(py, numbers).reshape(shape).expect("as many numbers as the shape has")
}

/// Of three numbers.
pub fn vector(py: Python<'_>, vector: DVec3) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, &vector.to_array())
}
