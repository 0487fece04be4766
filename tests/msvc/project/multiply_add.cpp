// SPDX-License-Identifier: MIT
double multiply_add(double a, double b, double c);
double multiply_add(double a, double b, double c) { return a * b + c; }
