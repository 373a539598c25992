/* window_sizes.c - finds the sizes at which edges of windows are blocked (stations),
 * from the smallest to the largest size, and interpolates the sizes between them. */
#include "studies/sizing/window_sizes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/sizing/window_number.h"
#include "model/base/array.h"

/* An edge that cannot be moved by this distance (m) is blocked. The distance exceeds
 * the gap that rounding to the grid leaves between adjoining windows. */
static const double blocked_m = 0.0035;

/* Lengths whose difference (m) is at most this are equal except for rounding. */
static const double slack_m = 1e-6;

struct pp_window_sizes {
    struct pp_room *room; /* present room */
    enum pp_size_change change;
    int *openings; /* indices of the openings that change */
    int opening_count;

    /* For all changes except PP_CHANGE_NUMBER: positions of the edges at each station,
     * from the smallest size to the largest. Edge 2 i is the lower (or left) edge of
     * opening i; edge 2 i + 1 is its upper (or right) edge. */
    bool upright;      /* true: sill and head move; false: left and right edges move */
    double **stations; /* stations, with 2 opening_count edges each */
    int station_count;
    int fineness; /* number of steps per millimetre */

    /* For PP_CHANGE_NUMBER: possible numbers of windows in the wall, ascending. */
    int *numbers;
    int number_count;
};

/* ---- edges of openings ---- */

/* Position and size of the i-th opening with these edges. */
static struct pp_opening_place sized_opening_place(const struct pp_window_sizes *sizes,
                                                   int i, const double *edges)
{
    struct pp_opening_place place =
        pp_room_opening_at(sizes->room, sizes->openings[i]).place;
    double low = edges[2 * i], high = edges[2 * i + 1];
    /* If neither edge has moved, position and length remain identical bit for bit. */
    double *first = sizes->upright ? &place.sill_m : &place.left_m;
    double *length = sizes->upright ? &place.height_m : &place.width_m;
    if (low != *first || high != *first + *length) {
        *first = low;
        *length = high - low;
    }
    return place;
}

/* Reads the edges of the present openings. */
static void read_edges(const struct pp_window_sizes *sizes, double *edges)
{
    for (int i = 0; i < sizes->opening_count; i++) {
        struct pp_opening_place place =
            pp_room_opening_at(sizes->room, sizes->openings[i]).place;
        edges[2 * i] = sizes->upright ? place.sill_m : place.left_m;
        edges[2 * i + 1] = sizes->upright ? place.sill_m + place.height_m
                                          : place.left_m + place.width_m;
    }
}

static void set_edges(const struct pp_window_sizes *sizes, struct pp_room *room,
                      const double *edges)
{
    for (int i = 0; i < sizes->opening_count; i++)
        pp_room_set_place(room, sizes->openings[i],
                          sized_opening_place(sizes, i, edges));
}

/* Rounds an edge to the grid, towards the inside of the window. */
static double on_grid(double edge_m, bool high, double grid_m)
{
    double n =
        high ? floor((edge_m + slack_m) / grid_m) : ceil((edge_m - slack_m) / grid_m);
    /* Divides, because 1000 is exact in binary and 0.001 is not. */
    return n / round(1.0 / grid_m) + 0.0;
}

/* ---- how far edges can move ---- */

/* Appends a station. The caller sets *edges. */
static enum pp_status add_station(double **edges, struct pp_window_sizes *sizes,
                                  struct pp_error *err)
{
    *edges = malloc(2 * (size_t)sizes->opening_count * sizeof **edges);
    if (!*edges)
        return pp_fail_memory(err);
    enum pp_status status = pp_array_append(&sizes->stations, sizes->station_count,
                                            sizeof *sizes->stations, err);
    if (status == PP_OK)
        sizes->stations[sizes->station_count++] = *edges;
    else
        free(*edges);
    return status;
}

/* Sets *possible to true if the room is valid with these edges. */
static enum pp_status is_possible(bool *possible, const struct pp_window_sizes *sizes,
                                  struct pp_room *trial, const double *edges,
                                  struct pp_error *err)
{
    set_edges(sizes, trial, edges);
    return pp_room_is_sound(possible, trial, err);
}

/* Sets moved = edges + by * way, for `count` edges. */
static void move_edges(double *moved, const double *edges, const double *way, double by,
                       int count)
{
    for (int e = 0; e < count; e++)
        moved[e] = edges[e] + by * way[e];
}

/* Finds the greatest movement of all edges together at which the room is valid, by
 * doubling and halving, to within slack_m. *by is the movement of the fastest edge (m).
 * moved: working memory. */
static enum pp_status farthest(double *by, const struct pp_window_sizes *sizes,
                               struct pp_room *trial, const double *edges,
                               const double *way, double *moved, struct pp_error *err)
{
    int count = 2 * sizes->opening_count;
    double good = 0.0, bad = 0.125;
    bool possible = true;
    while (possible && bad < 1e5) {
        move_edges(moved, edges, way, bad, count);
        enum pp_status status = is_possible(&possible, sizes, trial, moved, err);
        if (status != PP_OK)
            return status;
        good = possible ? bad : good;
        bad = possible ? 2.0 * bad : bad;
    }
    while (bad - good > 0.5 * slack_m) {
        double middle = 0.5 * (good + bad);
        move_edges(moved, edges, way, middle, count);
        enum pp_status status = is_possible(&possible, sizes, trial, moved, err);
        if (status != PP_OK)
            return status;
        *(possible ? &good : &bad) = middle;
    }
    *by = good;
    return PP_OK;
}

/* Sets to 0 the speed of each edge that cannot move even alone. *stopped is set to the
 * number of these edges. */
static enum pp_status stop_blocked(int *stopped, const struct pp_window_sizes *sizes,
                                   struct pp_room *trial, const double *edges,
                                   double *way, double *moved, struct pp_error *err)
{
    int count = 2 * sizes->opening_count;
    *stopped = 0;
    for (int e = 0; e < count; e++) {
        bool possible = true;
        if (way[e] == 0.0)
            continue;
        memcpy(moved, edges, (size_t)count * sizeof *moved);
        moved[e] += copysign(blocked_m, way[e]);
        enum pp_status status = is_possible(&possible, sizes, trial, moved, err);
        if (status != PP_OK)
            return status;
        if (!possible) {
            way[e] = 0.0;
            ++*stopped;
        }
    }
    return PP_OK;
}

/* Adds the next station, at which one of the moving edges is blocked. *done is set to
 * true if no edge can move, or if no edge was found to be blocked. */
static enum pp_status advance_sizes(bool *done, struct pp_window_sizes *sizes,
                                    struct pp_room *trial, double *way, double *moved,
                                    struct pp_error *err)
{
    int count = 2 * sizes->opening_count, stopped;
    const double *from = sizes->stations[sizes->station_count - 1];
    double by = 0.0;
    enum pp_status status = farthest(&by, sizes, trial, from, way, moved, err);
    if (status != PP_OK)
        return status;
    double *to;
    status = add_station(&to, sizes, err);
    if (status != PP_OK)
        return status;
    from = sizes->stations[sizes->station_count - 2];
    for (int e = 0; e < count; e++) {
        double edge = on_grid(from[e] + by * way[e], e % 2, PP_SIZE_GRID_M);
        bool out = e % 2 ? edge > from[e] : edge < from[e];
        to[e] = out ? edge : from[e];
    }
    status = stop_blocked(&stopped, sizes, trial, to, way, moved, err);
    bool moves = false;
    for (int e = 0; e < count; e++)
        moves = moves || way[e] != 0.0;
    *done = !moves || stopped == 0;
    return status;
}

/* Gets the outward speed of each edge in part `leg` of the change; 0 for an edge that
 * does not move. Returns false if there is no such part. A change of height has two
 * parts (first head, then sill); any other change has one. */
static bool way_of(const struct pp_window_sizes *sizes, int leg, double *way)
{
    double widest = 0.0;
    for (int i = 0; i < sizes->opening_count; i++) {
        struct pp_room_opening o = pp_room_opening_at(sizes->room, sizes->openings[i]);
        widest = fmax(widest, o.place.width_m);
    }
    bool height = sizes->change == PP_CHANGE_HEIGHT;
    for (int i = 0; i < sizes->opening_count; i++) {
        struct pp_room_opening o = pp_room_opening_at(sizes->room, sizes->openings[i]);
        bool rooflight = o.kind == PP_ROOFLIGHT;
        bool low =
            sizes->change == PP_CHANGE_SILL || (height && (leg == 1 || rooflight));
        bool high =
            sizes->change == PP_CHANGE_HEAD || (height && (leg == 0 || rooflight));
        way[2 * i] = low ? -1.0 : 0.0;
        way[2 * i + 1] = high ? 1.0 : 0.0;
        if (sizes->change == PP_CHANGE_WIDTH) {
            way[2 * i + 1] = o.place.width_m / widest;
            way[2 * i] = -way[2 * i + 1];
        }
    }
    return leg == 0 || (height && leg == 1);
}

/* Finds the edges of the smallest size, from which edges move outwards. */
static void shrink(const struct pp_window_sizes *sizes, const double *now,
                   const double *way, double *least)
{
    for (int i = 0; i < sizes->opening_count; i++) {
        double low = now[2 * i], high = now[2 * i + 1];
        double length = fmin(PP_SIZE_LEAST_M, high - low);
        bool low_moves = way[2 * i] != 0.0, high_moves = way[2 * i + 1] != 0.0;
        double middle = 0.5 * (low + high);
        least[2 * i] = !low_moves    ? low
                       : !high_moves ? high - length
                                     : middle - 0.5 * length;
        least[2 * i + 1] = least[2 * i] + length;
        if (!high_moves)
            least[2 * i + 1] = high;
    }
}

/* Finds the stations of the change: the smallest size, the present room, and each size
 * at which an edge is blocked. */
static enum pp_status find_stations(struct pp_window_sizes *sizes, struct pp_error *err)
{
    int count = 2 * sizes->opening_count;
    struct pp_room *trial = NULL;
    double *way = calloc(2 * (size_t)count, sizeof *way), *moved = way + count;
    double *least, *now;
    enum pp_status status =
        way ? pp_room_copy(&trial, sizes->room, err) : pp_fail_memory(err);
    if (status == PP_OK)
        status = add_station(&least, sizes, err);
    if (status == PP_OK)
        status = add_station(&now, sizes, err);
    if (status == PP_OK) {
        read_edges(sizes, now);
        way_of(sizes, 0, way);
        shrink(sizes, now, way, least);
    }
    for (int leg = 0; status == PP_OK && way_of(sizes, leg, way); leg++) {
        int stopped;
        status =
            stop_blocked(&stopped, sizes, trial,
                         sizes->stations[sizes->station_count - 1], way, moved, err);
        bool done = true;
        for (int e = 0; e < count; e++)
            done = done && way[e] == 0.0;
        while (status == PP_OK && !done)
            status = advance_sizes(&done, sizes, trial, way, moved, err);
    }
    pp_room_destroy(trial);
    free(way);
    return status;
}

/* ---- steps ---- */

/* Length (m) by which an opening grows from a station to the next station. */
static double growth(const struct pp_window_sizes *sizes, int station, int opening)
{
    const double *from = sizes->stations[station] + 2 * opening;
    const double *to = sizes->stations[station + 1] + 2 * opening;
    return fabs(to[0] - from[0]) + fabs(to[1] - from[1]);
}

/* Number of steps between a station and the next station: the greatest growth of an
 * opening divided by the grid spacing. */
static int steps_between(const struct pp_window_sizes *sizes, int station)
{
    double most = 0.0;
    for (int i = 0; i < sizes->opening_count; i++)
        most = fmax(most, growth(sizes, station, i));
    return (int)ceil((most - slack_m) / PP_SIZE_GRID_M) * sizes->fineness;
}

int pp_window_sizes_count(const struct pp_window_sizes *sizes)
{
    if (sizes->change == PP_CHANGE_NUMBER)
        return sizes->number_count;
    int count = 1;
    for (int s = 0; s + 1 < sizes->station_count; s++)
        count += steps_between(sizes, s);
    return count;
}

int pp_window_sizes_now(const struct pp_window_sizes *sizes)
{
    for (int i = 0; i < sizes->number_count; i++)
        if (sizes->numbers[i] == sizes->opening_count)
            return i;
    return steps_between(sizes, 0);
}

void pp_window_sizes_refine(struct pp_window_sizes *sizes)
{
    sizes->fineness *= 10;
}

/* Finds the edges at a step, interpolated between two stations and rounded to the
 * grid. */
static void edges_at(const struct pp_window_sizes *sizes, int step, double *edges)
{
    int station = 0, steps = 0;
    while (station + 2 < sizes->station_count
           && step > (steps = steps_between(sizes, station))) {
        step -= steps;
        station++;
    }
    steps = steps_between(sizes, station);
    const double *from = sizes->stations[station], *to = sizes->stations[station + 1];
    double u = steps > 0 ? (double)step / steps : 1.0;
    for (int e = 0; e < 2 * sizes->opening_count; e++) {
        edges[e] = step == steps ? to[e] : from[e];
        if (step == 0 || step == steps || from[e] == to[e])
            continue;
        /* If both edges of an opening move, each of them moves by half a step. */
        bool both = from[e ^ 1] != to[e ^ 1];
        double grid_m = PP_SIZE_GRID_M / sizes->fineness / (both ? 2.0 : 1.0);
        edges[e] = on_grid(from[e] + u * (to[e] - from[e]), e % 2, grid_m);
    }
}

enum pp_status pp_window_sizes_room(struct pp_room **room,
                                    const struct pp_window_sizes *sizes, int step,
                                    struct pp_error *err)
{
    if (sizes->change == PP_CHANGE_NUMBER)
        return pp_window_number_room(room, sizes->room, sizes->openings,
                                     sizes->opening_count, sizes->numbers[step], err);
    double *edges = malloc(2 * (size_t)sizes->opening_count * sizeof *edges);
    *room = NULL;
    if (!edges)
        return pp_fail_memory(err);
    enum pp_status status = pp_room_copy(room, sizes->room, err);
    if (status == PP_OK) {
        edges_at(sizes, step, edges);
        set_edges(sizes, *room, edges);
    }
    free(edges);
    return status;
}

/* ---- creation ---- */

/* Returns PP_BAD_INPUT if the opening does not allow this change. */
static enum pp_status check_opening(const struct pp_room *room, int index,
                                    enum pp_size_change change, struct pp_error *err)
{
    struct pp_room_opening opening = pp_room_opening_at(room, index);
    if (opening.kind == PP_OPENING)
        return pp_fail(err, PP_BAD_INPUT,
                       "the opening on line %d is given by its corners and cannot be "
                       "resized; expected a window or a rooflight",
                       opening.line);
    if (opening.kind == PP_ROOFLIGHT && change != PP_CHANGE_WIDTH
        && change != PP_CHANGE_HEIGHT)
        return pp_fail(
            err, PP_BAD_INPUT,
            "only the width and the depth of the rooflight on line %d can be changed; "
            "expected --change width, or --change height (its depth)",
            opening.line);
    return PP_OK;
}

enum pp_status pp_window_sizes_create(struct pp_window_sizes **sizes,
                                      const struct pp_room *room,
                                      enum pp_size_change change, const int *openings,
                                      int opening_count, struct pp_error *err)
{
    *sizes = NULL;
    if (opening_count < 1)
        return pp_fail(err, PP_BAD_INPUT, "there is no window to change");
    for (int i = 0; i < opening_count; i++) {
        enum pp_status status = check_opening(room, openings[i], change, err);
        if (status != PP_OK)
            return status;
    }
    struct pp_window_sizes *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    made->change = change;
    made->upright = change != PP_CHANGE_WIDTH;
    made->fineness = 1;
    made->openings = malloc((size_t)opening_count * sizeof *openings);
    enum pp_status status =
        made->openings ? pp_room_copy(&made->room, room, err) : pp_fail_memory(err);
    if (status == PP_OK) {
        memcpy(made->openings, openings, (size_t)opening_count * sizeof *openings);
        made->opening_count = opening_count;
        status = change == PP_CHANGE_NUMBER
                     ? pp_window_number_choices(&made->numbers, &made->number_count,
                                                room, openings, opening_count, err)
                     : find_stations(made, err);
    }
    if (status == PP_OK)
        *sizes = made;
    else
        pp_window_sizes_destroy(made);
    return status;
}

void pp_window_sizes_destroy(struct pp_window_sizes *sizes)
{
    if (!sizes)
        return;
    for (int s = 0; s < sizes->station_count; s++)
        free(sizes->stations[s]);
    free(sizes->stations);
    free(sizes->numbers);
    free(sizes->openings);
    pp_room_destroy(sizes->room);
    free(sizes);
}
