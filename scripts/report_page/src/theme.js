// Light and dark: as the system says, until the reader says otherwise; always light on paper.

const root = document.documentElement;
const dark = matchMedia('(prefers-color-scheme: dark)');
const listeners = [];
let chosen = null;
let printing = false;

export const colour = (name) => getComputedStyle(root).getPropertyValue(`--${name}`).trim();
export const onTheme = (listener) => listeners.push(listener);
export const onPaper = () => printing;
export const isDark = () => !printing && (chosen ?? (dark.matches ? 'dark' : 'light')) === 'dark';

function apply() {
  root.dataset.theme = isDark() ? 'dark' : 'light';
  for (const listener of listeners) listener();
}

export function themeSwitch(button) {
  const say = () => {
    button.textContent = isDark() ? 'Light' : 'Dark';
    button.setAttribute('aria-label', `switch to the ${isDark() ? 'light' : 'dark'} theme`);
  };
  button.addEventListener('click', () => {
    chosen = isDark() ? 'light' : 'dark';
    apply();
  });
  onTheme(say);
  say();
}

export function followTheme() {
  dark.addEventListener('change', apply);
  addEventListener('beforeprint', () => {
    printing = true;
    apply();
  });
  addEventListener('afterprint', () => {
    printing = false;
    apply();
  });
  apply();
}
