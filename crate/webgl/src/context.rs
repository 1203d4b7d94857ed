use std::cell::RefCell;
use std::fmt;
use std::ops::Deref;
use std::rc::Rc;
use std::sync::Arc;

use web_sys::{WebGl2RenderingContext as Gl, WebGlFramebuffer, WebGlSync};

/// What every object holds: the context of the canvas, and what is common to all that is made with it.
#[derive(Clone)]
pub(crate) struct Context(Rc<Shared>);

pub(crate) struct Shared {
    gl: Gl,
    /// What a pass draws into.
    pub(crate) drawn: Option<WebGlFramebuffer>,
    /// What is resolved into, presented or read.
    pub(crate) copied: Option<WebGlFramebuffer>,
    /// Buffers to be read, each with what is passed when it can be.
    pub(crate) waiting: RefCell<Vec<(Option<WebGlSync>, wgpu::custom::BufferMapCallback)>>,
    pub(crate) on_error: RefCell<Option<Arc<dyn wgpu::UncapturedErrorHandler>>>,
}

impl Context {
    pub(crate) fn new(gl: Gl) -> Self {
        // Rows follow each other without a gap.
        gl.pixel_storei(Gl::UNPACK_ALIGNMENT, 1);
        let (drawn, copied) = (gl.create_framebuffer(), gl.create_framebuffer());
        Self(Rc::new(Shared { gl, drawn, copied, waiting: RefCell::default(), on_error: RefCell::default() }))
    }

    /// What the context allows.
    pub(crate) fn limits(&self) -> wgpu::Limits {
        let number = |name| self.get_parameter(name).ok().and_then(|value| value.as_f64()).unwrap_or_default() as u32;
        wgpu::Limits {
            max_texture_dimension_1d: number(Gl::MAX_TEXTURE_SIZE),
            max_texture_dimension_2d: number(Gl::MAX_TEXTURE_SIZE),
            max_texture_dimension_3d: number(Gl::MAX_3D_TEXTURE_SIZE),
            max_buffer_size: i32::MAX as u64,
            ..wgpu::Limits::downlevel_webgl2_defaults()
        }
    }

    /// Passes what went wrong outside of any call.
    pub(crate) fn report(&self, description: String) {
        let handler = self.on_error.borrow().clone();
        if let Some(handler) = handler {
            handler(wgpu::Error::Internal { source: description.clone().into(), description });
        }
    }

    /// Passes on what has come since it was asked for.
    pub(crate) fn poll(&self) {
        let status = |sync: &Option<WebGlSync>| match sync {
            Some(sync) => self.get_sync_parameter(sync, Gl::SYNC_STATUS) == Gl::SIGNALED,
            // The context is lost, and nothing comes any more.
            None => false,
        };
        let (ready, waiting) = self.waiting.take().into_iter().partition(|(sync, _)| status(sync));
        self.waiting.replace(waiting);
        let ready: Vec<_> = ready;
        for (sync, callback) in ready {
            self.delete_sync(sync.as_ref());
            callback(Ok(()));
        }
    }
}

impl Deref for Context {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        &self.0
    }
}

impl Deref for Shared {
    type Target = Gl;

    fn deref(&self) -> &Gl {
        &self.gl
    }
}

impl fmt::Debug for Context {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("WebGL2")
    }
}
