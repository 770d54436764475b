// The page's colours, read from its style sheet so that light and dark are decided in one place.

import { Color } from 'three';

export const SERIES_COLORS = 8;
const BODY_COLORS = ['--b1', '--b2', '--b3', '--b4', '--b5', '--b6'];

/** A fresh reading; make a new one when the colour scheme changes. */
export function readTheme(element = document.documentElement) {
  const style = getComputedStyle(element);
  const css = (name) => style.getPropertyValue(name).trim();
  const color = (name) => new Color(css(name));
  return {
    css,
    color,
    dark: css('--scheme') === 'dark',
    body: (index) => color(BODY_COLORS[index % BODY_COLORS.length]),
  };
}
