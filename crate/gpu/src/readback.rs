//! Bytes that come back from the device.

use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll, Waker};

use crate::error::{Error, Result};

/// Reads a buffer that may be mapped, once all that was submitted is done.
///
/// # Errors
/// [`Error::Device`].
pub async fn read<T: bytemuck::Pod>(device: &wgpu::Device, buffer: &wgpu::Buffer) -> Result<Vec<T>> {
    let mapping = Mapping::default();
    buffer.map_async(wgpu::MapMode::Read, .., {
        let mapping = mapping.clone();
        move |result| mapping.finish(result)
    });
    // Of a program's device nobody else asks; a browser's needs no asking.
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| device_error(&error))?;
    mapping.await.map_err(|error| device_error(&error))?;
    let mapped = buffer.get_mapped_range(..).map_err(|error| device_error(&error))?;
    let values = bytemuck::pod_collect_to_vec(&mapped);
    drop(mapped);
    buffer.unmap();
    Ok(values)
}

fn device_error(error: &impl ToString) -> Error {
    Error::Device { reason: error.to_string() }
}

/// What a device answers to a wish to map a buffer, to be waited for.
#[derive(Clone, Default)]
struct Mapping(Arc<Mutex<Answer>>);

#[derive(Default)]
struct Answer {
    result: Option<Result<(), wgpu::BufferAsyncError>>,
    waker: Option<Waker>,
}

impl Mapping {
    fn finish(&self, result: Result<(), wgpu::BufferAsyncError>) {
        let mut answer = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        answer.result = Some(result);
        answer.waker.take().into_iter().for_each(Waker::wake);
    }
}

impl Future for Mapping {
    type Output = Result<(), wgpu::BufferAsyncError>;

    fn poll(self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<Self::Output> {
        let mut answer = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match answer.result.take() {
            Some(result) => Poll::Ready(result),
            None => {
                answer.waker = Some(context.waker().clone());
                Poll::Pending
            }
        }
    }
}
