/** What the clipboard holds: files, an address, other text. */
import { addressIn, namesMesh } from '../../files/address';
import type { Opener } from '../../session/opener';
import { itemsOf } from './files';
import { isTyping } from './typing';

export function followPaste(opener: Opener): void {
  addEventListener('paste', (event) => {
    const { clipboardData } = event;
    if (!clipboardData || isTyping(event)) return;
    const text = clipboardData.getData('text/plain');
    const address = addressIn(text);
    if (clipboardData.files.length > 0) void opener.files(itemsOf(clipboardData.items));
    else if (address && namesMesh(address)) void opener.address(address);
    else if (text.trim()) void opener.pasted(text);
    else return;
    event.preventDefault();
  });
}
