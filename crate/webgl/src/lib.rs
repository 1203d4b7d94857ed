//! wgpu on WebGL2, as much of it as the viewer uses. wgpu's own way to WebGL2 checks every command and translates shaders in the
//! browser, which is three times as much code as the whole of the viewer. Here a build has checked and translated the shaders,
//! and commands are checked where the same calls go to WebGPU or Vulkan.
//!
//! What is there: buffers, textures of one layer, bind groups of uniform buffers, textures and samplers, render passes with at
//! most one color attachment, and reading pictures back. What is not there panics with its name.
//!
//! Images are drawn upside down and turned over when they get to the canvas, as wgpu does it: OpenGL counts rows from the bottom.
//!
//! # Shaders
//!
//! A module comes through `wgpu::Device::create_shader_module_passthrough` as GLSL. Its entry points stand one after the other,
//! each below a line of words: `//`, the entry point, and the uniforms that it uses. These have their places as names: `u_G_B_S` for
//! a uniform block of group G and binding B in stage S, `t_G_B_G_B` for a texture with its sampler.
#![cfg(target_arch = "wasm32")]

mod canvas;
mod command;
mod context;
mod convert;
mod device;
mod player;
mod program;
mod resource;

pub use crate::canvas::instance;
