/* angle_basis.c - see angle_basis.h. */
#include "model/light/bsdf/angle_basis.h"

#include <stdlib.h>
#include <string.h>

/* Bounds of the rings (degrees) and their numbers of patches, as WINDOW writes them. */
static const struct {
    const char *name;
    int rings;
    double bounds[10];
    int patches[9];
} klems[] = {
    {"LBNL/Klems Full",
     9,
     {0, 5, 15, 25, 35, 45, 55, 65, 75, 90},
     {1, 8, 16, 20, 24, 24, 24, 16, 12}},
    {"LBNL/Klems Half",
     7,
     {0, 6.5, 19.5, 32.5, 45.5, 58.5, 71.5, 90},
     {1, 8, 12, 16, 20, 12, 8}},
    {"LBNL/Klems Quarter", 5, {0, 9, 27, 45, 63, 90}, {1, 8, 12, 12, 8}},
};

bool pp_angle_basis_add_ring(struct pp_angle_basis *basis, double low_rad,
                             double high_rad, int patches)
{
    static const double SAME = 1e-4 * PP_RAD;
    int n = basis->ring_count;
    double before = n > 0 ? basis->rings[n - 1].high_rad : 0.0;
    if (n == PP_ANGLE_BASIS_RINGS_MOST || patches < 1
        || (patches > 1 && patches % 2 == 1)
        || patches > PP_ANGLE_BASIS_PATCHES_MOST - basis->count
        || !(fabs(low_rad - before) < SAME) || !(high_rad > low_rad + SAME)
        || !(high_rad < 0.5 * PP_PI + SAME))
        return false;
    basis->rings[n] = (struct pp_angle_ring){before, fmin(high_rad, 0.5 * PP_PI),
                                             patches, basis->count};
    basis->ring_count++;
    basis->count += patches;
    return true;
}

bool pp_angle_basis_named(struct pp_angle_basis *basis, const char *name)
{
    *basis = (struct pp_angle_basis){.count = 0};
    for (size_t i = 0; i < sizeof klems / sizeof *klems; i++) {
        if (strcmp(klems[i].name, name) != 0)
            continue;
        for (int k = 0; k < klems[i].rings; k++)
            pp_angle_basis_add_ring(basis, klems[i].bounds[k] * PP_RAD,
                                    klems[i].bounds[k + 1] * PP_RAD,
                                    klems[i].patches[k]);
        return true;
    }
    return false;
}

struct pp_angle_basis pp_angle_basis_grid(int side)
{
    return (struct pp_angle_basis){.count = side * side, .side = side};
}

bool pp_angle_basis_is_same(const struct pp_angle_basis *a,
                            const struct pp_angle_basis *b)
{
    if (a->count != b->count || a->side != b->side || a->ring_count != b->ring_count)
        return false;
    for (int i = 0; i < a->ring_count; i++)
        if (a->rings[i].patches != b->rings[i].patches
            || !(fabs(a->rings[i].high_rad - b->rings[i].high_rad) < 1e-6))
            return false;
    return true;
}

static const struct pp_angle_ring *ring_of(const struct pp_angle_basis *basis,
                                           int patch)
{
    int i = 0;
    while (i + 1 < basis->ring_count && patch >= basis->rings[i + 1].first)
        i++;
    return &basis->rings[i];
}

static double squared_sine(double angle_rad)
{
    double s = sin(angle_rad);
    return s * s;
}

double pp_angle_basis_projected(const struct pp_angle_basis *basis, int patch)
{
    if (basis->side > 0)
        return PP_PI / basis->count;
    const struct pp_angle_ring *ring = ring_of(basis, patch);
    return PP_PI * (squared_sine(ring->high_rad) - squared_sine(ring->low_rad))
           / ring->patches;
}

/* The equal-area map between the unit disc and the square, each coordinate from 0 to
 * 1. */
static void disc_to_square(double x, double y, double square[2])
{
    const double QUARTER = PP_PI / 4.0;
    double r = hypot(x, y), phi = atan2(y, x), a, b;
    if (phi < -QUARTER)
        phi += 2.0 * PP_PI;
    if (phi < QUARTER) {
        a = r;
        b = phi * r / QUARTER;
    } else if (phi < 3.0 * QUARTER) {
        b = r;
        a = (PP_PI / 2.0 - phi) * r / QUARTER;
    } else if (phi < 5.0 * QUARTER) {
        a = -r;
        b = (PP_PI - phi) * r / QUARTER;
    } else {
        b = -r;
        a = (phi - 1.5 * PP_PI) * r / QUARTER;
    }
    square[0] = 0.5 * (a + 1.0);
    square[1] = 0.5 * (b + 1.0);
}

static struct pp_vec3 square_to_direction(double u, double v)
{
    double a = 2.0 * u - 1.0, b = 2.0 * v - 1.0, r, phi;
    if (fabs(a) > fabs(b)) {
        r = a;
        phi = PP_PI / 4.0 * b / a;
    } else {
        r = b;
        phi = PP_PI / 2.0 - (b != 0.0 ? PP_PI / 4.0 * a / b : 0.0);
    }
    return pp_vec(r * cos(phi), r * sin(phi), sqrt(fmax(0.0, 1.0 - r * r)));
}

static int cell_of(double coordinate, int side)
{
    int cell = (int)(coordinate * side);
    return cell < 0 ? 0 : cell >= side ? side - 1 : cell;
}

int pp_angle_basis_find(const struct pp_angle_basis *basis, struct pp_vec3 direction)
{
    if (basis->side > 0) {
        double square[2];
        disc_to_square(direction.x, direction.y, square);
        return cell_of(square[0], basis->side) * basis->side
               + cell_of(square[1], basis->side);
    }
    double theta = asin(fmin(1.0, hypot(direction.x, direction.y)));
    int i = 0;
    while (i + 1 < basis->ring_count && theta >= basis->rings[i].high_rad)
        i++;
    const struct pp_angle_ring *ring = &basis->rings[i];
    double turn = atan2(direction.y, direction.x) / (2.0 * PP_PI);
    int k = (int)floor(turn * ring->patches + 0.5);
    return ring->first + (k + ring->patches) % ring->patches;
}

struct pp_vec3 pp_angle_basis_direction(const struct pp_angle_basis *basis, int patch,
                                        double u, double v)
{
    if (basis->side > 0)
        return square_to_direction((patch / basis->side + u) / basis->side,
                                   (patch % basis->side + v) / basis->side);
    const struct pp_angle_ring *ring = ring_of(basis, patch);
    double low = squared_sine(ring->low_rad), high = squared_sine(ring->high_rad);
    double sine2 = low + u * (high - low), sine = sqrt(sine2);
    double phi = 2.0 * PP_PI * (patch - ring->first + v - 0.5) / ring->patches;
    return pp_vec(sine * cos(phi), sine * sin(phi), sqrt(fmax(0.0, 1.0 - sine2)));
}

int pp_angle_basis_opposite(const struct pp_angle_basis *basis, int patch)
{
    if (basis->side > 0)
        return basis->count - 1 - patch;
    const struct pp_angle_ring *ring = ring_of(basis, patch);
    return ring->first + (patch - ring->first + ring->patches / 2) % ring->patches;
}

/* True if the azimuth ranges of two patches touch or overlap: patch i of ring a and
 * patch k of ring b. */
static bool azimuths_touch(const struct pp_angle_ring *a, int i,
                           const struct pp_angle_ring *b, int k)
{
    double apart = fabs((double)i / a->patches - (double)k / b->patches);
    apart = fmin(apart, 1.0 - apart);
    return apart < 0.5 / a->patches + 0.5 / b->patches + 1e-9;
}

bool pp_angle_basis_is_adjacent(const struct pp_angle_basis *basis, int a, int b)
{
    if (a == b)
        return false;
    if (basis->side > 0)
        return abs(a / basis->side - b / basis->side) <= 1
               && abs(a % basis->side - b % basis->side) <= 1;
    const struct pp_angle_ring *first = ring_of(basis, a), *second = ring_of(basis, b);
    return labs(first - second) <= 1
           && azimuths_touch(first, a - first->first, second, b - second->first);
}
