/* moving_fit.c - solves the normal equations of a quadratic fit by Cholesky's
 * method. */
#include "studies/moving_fit.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { TERMS = 6 };

/* Solves the symmetric positive system by Cholesky's method. An unknown that is almost
 * determined by previous unknowns is set to 0. */
static void solve(double matrix[TERMS][TERMS], double right[TERMS])
{
    double scale[TERMS];
    for (int i = 0; i < TERMS; i++)
        scale[i] = matrix[i][i];
    bool used[TERMS];
    for (int i = 0; i < TERMS; i++) {
        for (int k = 0; k < i; k++)
            if (used[k])
                matrix[i][i] -= matrix[i][k] * matrix[i][k];
        used[i] = matrix[i][i] > 1e-6 * scale[i];
        if (!used[i])
            continue;
        matrix[i][i] = sqrt(matrix[i][i]);
        for (int j = i + 1; j < TERMS; j++) {
            for (int k = 0; k < i; k++)
                if (used[k])
                    matrix[j][i] -= matrix[j][k] * matrix[i][k];
            matrix[j][i] /= matrix[i][i];
        }
    }
    for (int i = 0; i < TERMS; i++) {
        for (int k = 0; k < i; k++)
            if (used[k])
                right[i] -= matrix[i][k] * right[k];
        right[i] = used[i] ? right[i] / matrix[i][i] : 0.0;
    }
    for (int i = TERMS - 1; i >= 0; i--) {
        for (int k = i + 1; k < TERMS; k++)
            if (used[i] && used[k])
                right[i] -= matrix[k][i] * right[k];
        right[i] = used[i] ? right[i] / matrix[i][i] : 0.0;
    }
}

static void terms_of(double terms[TERMS], const double at[2])
{
    double x = at[0], y = at[1];
    const double values[TERMS] = {1.0, x, y, x * x, x * y, y * y};
    memcpy(terms, values, sizeof values);
}

void pp_moving_fit_coefficients(double *weights, const double (*offsets)[2], int count)
{
    double matrix[TERMS][TERMS] = {{0.0}}, right[TERMS] = {1.0}, terms[TERMS];
    for (int n = 0; n < count; n++) {
        terms_of(terms, offsets[n]);
        for (int i = 0; i < TERMS; i++)
            for (int j = 0; j <= i; j++)
                matrix[i][j] += weights[n] * terms[i] * terms[j];
    }
    solve(matrix, right);
    for (int n = 0; n < count; n++) {
        double sum = 0.0;
        terms_of(terms, offsets[n]);
        for (int i = 0; i < TERMS; i++)
            sum += right[i] * terms[i];
        weights[n] *= sum;
    }
}
