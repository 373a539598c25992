/* watertight.c - see watertight.h.
 *
 * The envelope is closed if every edge belongs to two faces that traverse it in
 * opposite directions. With all normals into the room the volume
 *
 *     V = -1/3 sum A n . c    (c any point of the face)
 *
 * is positive. Faces with the wrong orientation are found by visiting neighbours. They
 * are reversed, so that further mistakes of the room are found too.
 */
#include "model/room/build/watertight.h"

#include <stdlib.h>

#include "model/geometry/polygons_cross.h"
#include "model/geometry/tolerance.h"

struct envelope_edge {
    int low, high; /* corner numbers */
    bool upward;   /* true if the face traverses the edge from low to high */
    int face;
    struct pp_vec3 from, to;
};

/* State of a face while its neighbours are visited. */
struct face_visit {
    int part;       /* connected part that contains the face; -1: not visited */
    bool turned;    /* oriented opposite to the first face of its part */
    int first;      /* index of its first entry in neighbours */
    int open_edges; /* number of edges that no other face shares */
    int first_open; /* index of the first such edge */
};

struct watertight_check {
    struct envelope_edge
        *edges; /* sorted; edges between the same two corners are adjacent */
    int edge_count;
    struct face_visit *faces;
    int *neighbours; /* faces that share an edge with a face, from its `first` on, in no
                      * order; -1: none */
    bool *same_way;  /* as neighbours: true if both faces traverse the common edge in
                      * the same direction */
    int part_count;
};

static int compare_edges(const void *left, const void *right)
{
    const struct envelope_edge *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return (a->face > b->face) - (a->face < b->face);
}

static void list_edges(const struct pp_resolver *r, struct watertight_check *c)
{
    int corner = 0;
    for (int i = 0; i < r->world->face_count; i++) {
        const struct pp_polygon *outline = &r->world->surfaces[i].outline;
        const int *numbers = r->corners + corner;
        c->faces[i] = (struct face_visit){.part = -1, .first = corner};
        for (int k = 0; k < outline->count; k++, corner++) {
            int next = (k + 1) % outline->count;
            int from = numbers[k], to = numbers[next];
            c->neighbours[corner] = -1;
            c->edges[corner] = (struct envelope_edge){.low = from < to ? from : to,
                                                      .high = from < to ? to : from,
                                                      .upward = from < to,
                                                      .face = i,
                                                      .from = outline->vertices[k],
                                                      .to = outline->vertices[next]};
        }
    }
    c->edge_count = corner;
    qsort(c->edges, corner, sizeof *c->edges, compare_edges);
}

/* Adds b's face to the neighbours of a's face. */
static void join_neighbours(struct watertight_check *c, const struct envelope_edge *a,
                            const struct envelope_edge *b)
{
    int at = c->faces[a->face].first;
    while (c->neighbours[at] >= 0)
        at++;
    c->neighbours[at] = b->face;
    c->same_way[at] = a->upward == b->upward;
}

/* Two faces that share an edge become neighbours; other edges are mistakes. */
static void match_edges(struct pp_resolver *r, struct watertight_check *c)
{
    const struct pp_surface *faces = r->world->surfaces;
    r->watertight = true;
    for (int i = 0, end; i < c->edge_count; i = end) {
        const struct envelope_edge *edge = &c->edges[i];
        for (end = i + 1; end < c->edge_count && c->edges[end].low == edge->low
                          && c->edges[end].high == edge->high;)
            end++;
        if (end - i == 2 && edge[0].face != edge[1].face) {
            join_neighbours(c, &edge[0], &edge[1]);
            join_neighbours(c, &edge[1], &edge[0]);
            continue;
        }
        r->watertight = false;
        if (end - i == 1) {
            if (c->faces[edge->face].open_edges++ == 0)
                c->faces[edge->face].first_open = i;
            continue;
        }
        pp_mistakes_add(r->mistakes, faces[c->edges[end - 1].face].line,
                        "face: its edge from (%g, %g, %g) to (%g, %g, %g) belongs to "
                        "%d faces, the first on line %d; expected two",
                        edge->from.x, edge->from.y, edge->from.z, edge->to.x,
                        edge->to.y, edge->to.z, end - i, faces[edge->face].line);
    }
    for (int i = 0; i < r->world->face_count; i++) {
        if (c->faces[i].open_edges == 0)
            continue;
        const struct envelope_edge *edge = &c->edges[c->faces[i].first_open];
        pp_mistakes_add(
            r->mistakes, faces[i].line,
            "face: the envelope is open at %d edges, such as the one from (%g, %g, %g) "
            "to (%g, %g, %g); expected two faces at every edge, with common corners",
            c->faces[i].open_edges, edge->from.x, edge->from.y, edge->from.z,
            edge->to.x, edge->to.y, edge->to.z);
    }
}

/* Visits all faces connected with the first, breadth first. */
static void visit_part(const struct pp_resolver *r, struct watertight_check *c,
                       int first, int *queue)
{
    int head = 0, tail = 0;
    c->faces[first].part = c->part_count++;
    queue[tail++] = first;
    while (head < tail) {
        int face = queue[head++];
        for (int k = 0; k < r->world->surfaces[face].outline.count; k++) {
            int at = c->faces[face].first + k, next = c->neighbours[at];
            if (next < 0 || c->faces[next].part >= 0)
                continue;
            c->faces[next].part = c->faces[face].part;
            c->faces[next].turned = c->faces[face].turned != c->same_way[at];
            queue[tail++] = next;
        }
    }
}

static void turn_round(struct pp_polygon *outline, int *corners)
{
    outline->normal = pp_vec_scale(outline->normal, -1.0);
    for (int a = 0, b = outline->count - 1; a < b; a++, b--) {
        struct pp_vec3 vertex = outline->vertices[a];
        outline->vertices[a] = outline->vertices[b];
        outline->vertices[b] = vertex;
        int corner = corners[a];
        corners[a] = corners[b];
        corners[b] = corner;
    }
}

/* Volume enclosed by the faces of a part; part -1: all faces. */
static double volume_m3(const struct pp_world *world, const struct watertight_check *c,
                        int part)
{
    double sum = 0.0;
    struct pp_vec3 origin = world->surfaces[0].outline.vertices[0];
    for (int i = 0; i < world->face_count; i++) {
        if (part >= 0 && c->faces[i].part != part)
            continue;
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        struct pp_vec3 from = pp_vec_sub(pp_polygon_middle(outline), origin);
        sum -= outline->area_m2 * pp_vec_dot(outline->normal, from);
    }
    return sum / 3.0;
}

/* Reverses the faces of each part that differ from the majority, and all faces if the
 * room is inside out; reports them. */
static void turn_faces(struct pp_resolver *r, struct watertight_check *c,
                       int *turned_in_part)
{
    struct pp_world *world = r->world;
    for (int i = 0; i < world->face_count; i++)
        turned_in_part[c->faces[i].part] += c->faces[i].turned ? 1 : -1;
    for (int i = 0; i < world->face_count; i++) {
        c->faces[i].turned ^= turned_in_part[c->faces[i].part] > 0;
        if (c->faces[i].turned)
            turn_round(&world->surfaces[i].outline, r->corners + c->faces[i].first);
    }
    bool inside_out = volume_m3(world, c, -1) < 0.0;
    bool all = true;
    for (int i = 0; i < world->face_count; i++) {
        if (inside_out) {
            turn_round(&world->surfaces[i].outline, r->corners + c->faces[i].first);
            c->faces[i].turned = !c->faces[i].turned;
        }
        all = all && c->faces[i].turned;
    }
    if (all)
        pp_mistakes_add(r->mistakes, r->room->plan.line,
                        "envelope: is inside out, because the vertices of all its "
                        "faces are clockwise seen from inside; expected "
                        "counter-clockwise");
    for (int i = 0; i < world->face_count && !all; i++)
        if (c->faces[i].turned)
            pp_mistakes_add(
                r->mistakes, world->surfaces[i].line,
                "face: its vertices are clockwise seen from inside; expected "
                "counter-clockwise");
}

/* Reports several separate rooms. A part with negative volume is a solid in the room
 * and is allowed; only one part may have a positive volume. */
static void check_parts(struct pp_resolver *r, const struct watertight_check *c)
{
    int rooms = 0;
    for (int part = 0; part < c->part_count; part++)
        rooms += volume_m3(r->world, c, part) > 0.0;
    if (rooms > 1)
        pp_mistakes_add(r->mistakes, r->room->plan.line,
                        "envelope: its faces form %d separate rooms; expected one",
                        rooms);
}

static enum pp_status check_closing(struct pp_resolver *r, struct watertight_check *c,
                                    struct pp_error *err)
{
    struct pp_world *world = r->world;
    list_edges(r, c);
    match_edges(r, c);
    if (!r->watertight)
        return PP_OK;
    int *queue = calloc(world->face_count, sizeof *queue);
    if (!queue)
        return pp_fail_memory(err);
    for (int i = 0; i < world->face_count; i++)
        if (c->faces[i].part < 0)
            visit_part(r, c, i, queue);
    for (int i = 0; i < world->face_count; i++)
        queue[i] = 0;
    turn_faces(r, c, queue);
    free(queue);
    check_parts(r, c);
    return PP_OK;
}

/* Reports faces of an envelope that cross each other. */
static enum pp_status check_crossings(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < i; k++) {
            bool cross;
            struct pp_vec3 where;
            if (pp_polygons_cross(&cross, &world->surfaces[i].outline,
                                  &world->surfaces[k].outline, &where, err)
                != PP_OK)
                return PP_SYSTEM;
            if (!cross)
                continue;
            r->watertight = false;
            pp_mistakes_add(r->mistakes, world->surfaces[i].line,
                            "face: intersects the face on line %d at (%g, %g, %g); "
                            "expected faces to meet at their edges only",
                            world->surfaces[k].line, where.x, where.y, where.z);
        }
    return PP_OK;
}

enum pp_status pp_build_watertight(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    if (world->face_count <= 0 || r->faces_missing)
        return PP_OK;
    size_t corner_count = 0;
    for (int i = 0; i < world->face_count; i++)
        corner_count += world->surfaces[i].outline.count;
    struct watertight_check c = {
        .edges = malloc(corner_count * sizeof *c.edges),
        .faces = malloc((size_t)world->face_count * sizeof *c.faces),
        .neighbours = malloc(corner_count * sizeof *c.neighbours),
        .same_way = malloc(corner_count * sizeof *c.same_way),
    };
    enum pp_status status = PP_OK;
    if (c.edges && c.faces && c.neighbours && c.same_way)
        status = check_closing(r, &c, err);
    else
        status = pp_fail_memory(err);
    free(c.edges);
    free(c.faces);
    free(c.neighbours);
    free(c.same_way);
    if (status == PP_OK && r->watertight && r->room->plan.envelope)
        status = check_crossings(r, err);
    return status;
}
