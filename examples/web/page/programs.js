export const programs = { cpp: () => "", command: () => "", javascript: () => "" };
