/**
 * The scripts that the page starts beside those that it is made of: its worker and its service worker, by addresses of its own, or of
 * what it makes itself. The page's content security policy lets none start whose address has not gone through here.
 */

/** Of browsers that have trusted types. */
interface Policies {
  createPolicy(name: string, rules: { createScriptURL: (address: string) => string | null }): unknown;
}

export function trustOwnScripts(): void {
  const { trustedTypes } = window as { trustedTypes?: Policies };
  trustedTypes?.createPolicy('default', { createScriptURL: (address) => (isOwn(address) ? address : null) });
}

function isOwn(address: string): boolean {
  const { protocol, origin } = new URL(address, document.baseURI);
  return protocol === 'blob:' || origin === location.origin;
}
