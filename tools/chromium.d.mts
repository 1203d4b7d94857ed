export const ALWAYS: readonly string[];
export const WEBGL: readonly string[];
export const MESA: readonly string[];
export const OPAQUE: string;
export const WEBGPU: readonly string[];
