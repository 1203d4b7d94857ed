import { expect, test } from '@playwright/test';
import { addressIn, nameOf, namesMesh } from '../../web/files/address';

for (const [text, address] of [
  [' https://models.example/cow.obj\n', 'https://models.example/cow.obj'],
  ['HTTP://Models.Example/cow.obj#part', 'http://models.example/cow.obj'],
  ['https://models.example/a b.obj', null],
  ['https://me:secret@models.example/cow.obj', null],
  ['ftp://models.example/cow.obj', null],
  ['javascript:alert(1)', null],
  ['see https://models.example/cow.obj', null],
  ['https://', null],
  ['cow.obj', null],
] as const) {
  test(`the text ${JSON.stringify(text)} is ${address ? 'an' : 'no'} address`, () => {
    expect(addressIn(text)).toBe(address);
  });
}

test('an address names a mesh by its path alone', () => {
  for (const address of [
    'https://a.example/cow.OBJ?raw=1',
    'https://a.example/x/set.zip',
    'https://a.example/my%20cow.stl',
  ])
    expect(namesMesh(address), address).toBe(true);
  for (const address of [
    'https://a.example/',
    'https://a.example/cow.obj/about',
    'https://cow.obj/',
    'https://a.example/?f=cow.obj',
  ])
    expect(namesMesh(address), address).toBe(false);
});

test('what is at an address is called by the name of the file, else by the host', () => {
  expect(nameOf('https://a.example/x/my%20cow.stl?raw=1')).toBe('my cow.stl');
  expect(nameOf('https://a.example/x/100%/')).toBe('100%');
  expect(nameOf('https://a.example:81/')).toBe('a.example:81');
});
