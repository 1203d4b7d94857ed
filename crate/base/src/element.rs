//! Numbered elements, and one value for each of them.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

use bytemuck::Zeroable;

/// A numbered element.
pub trait Element: Copy + Send + Sync + Zeroable {
    /// The element of this number, counted from 0.
    ///
    /// # Panics
    /// From 2³² on: no mesh has so many elements.
    fn from_index(index: usize) -> Self;

    /// Its number, counted from 0.
    fn index(self) -> usize;
}

/// One value for each element of a kind.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementData<E, T> {
    values: Vec<T>,
    element: PhantomData<E>,
}

impl<E, T> From<Vec<T>> for ElementData<E, T> {
    fn from(values: Vec<T>) -> Self {
        Self { values, element: PhantomData }
    }
}

impl<E, T> FromIterator<T> for ElementData<E, T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Vec::from_iter(values).into()
    }
}

impl<E, T> Default for ElementData<E, T> {
    fn default() -> Self {
        Vec::new().into()
    }
}

impl<E, T> ElementData<E, T> {
    /// Number of values.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The values in element order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// The values in element order.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.values.iter_mut()
    }

    /// The values in element order.
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }

    /// The values in element order.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// The values in element order.
    pub fn into_vec(self) -> Vec<T> {
        self.values
    }
}

impl<E: Element, T> ElementData<E, T> {
    /// The elements in order.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = E> + DoubleEndedIterator + Clone + use<E, T> {
        (0..self.values.len()).map(E::from_index)
    }

    /// The elements with their values, in order.
    pub fn enumerate(&self) -> impl ExactSizeIterator<Item = (E, &T)> + DoubleEndedIterator + Clone {
        self.values.iter().enumerate().map(|(index, value)| (E::from_index(index), value))
    }

    /// The value of an element, if there is such an element.
    pub fn get(&self, element: E) -> Option<&T> {
        self.values.get(element.index())
    }
}

impl<'a, E, T> IntoIterator for &'a ElementData<E, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, E, T> IntoIterator for &'a mut ElementData<E, T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

impl<E: Element, T> Index<E> for ElementData<E, T> {
    type Output = T;

    #[inline]
    fn index(&self, element: E) -> &T {
        &self.values[element.index()]
    }
}

impl<E: Element, T> IndexMut<E> for ElementData<E, T> {
    #[inline]
    fn index_mut(&mut self, element: E) -> &mut T {
        &mut self.values[element.index()]
    }
}
