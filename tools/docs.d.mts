import type { Plugin } from 'vite';

export function docs(root: string): Plugin;

export function readDocuments(folder: string): {
  pages: { name: string; title: string; html: string }[];
  sections: { page: string; title: string; id: string; heading: string; text: string }[];
};
