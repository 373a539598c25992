/* mesh.c - see mesh.h. */
#include "model/geometry/contour/mesh.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"

/* Ensures space for one more item than `count`. */
static bool reserve(void *list, int *room, int count, size_t size)
{
    return pp_array_reserve(list, room, count + 1, size, NULL) == PP_OK;
}

void pp_mesh_clear(struct pp_mesh *mesh)
{
    free(mesh->nodes);
    free(mesh->triangles);
    free(mesh->edges);
    free(mesh->table);
    *mesh = (struct pp_mesh){0};
}

/* ---- edges by their nodes ---- */

/* Slot that holds the edge of nodes a < b, or the free slot for it. */
static unsigned mesh_edge_slot(const struct pp_mesh *mesh, int a, int b)
{
    uint64_t key = (uint64_t)a << 32 | (uint32_t)b;
    unsigned mask = (unsigned)mesh->table_room - 1;
    unsigned slot = (unsigned)(key * 0x9e3779b97f4a7c15u >> 40) & mask;
    while (mesh->table[slot] >= 0) {
        const struct pp_mesh_edge *edge = &mesh->edges[mesh->table[slot]];
        if (edge->a == a && edge->b == b)
            break;
        slot = (slot + 1) & mask;
    }
    return slot;
}

int pp_mesh_edge(const struct pp_mesh *mesh, int a, int b)
{
    return mesh->table[a < b ? mesh_edge_slot(mesh, a, b) : mesh_edge_slot(mesh, b, a)];
}

static bool grow_table(struct pp_mesh *mesh)
{
    if (2 * (mesh->edge_count + 1) < mesh->table_room)
        return true;
    int room = mesh->table_room ? 2 * mesh->table_room : 1024;
    int *table = malloc((size_t)room * sizeof *table);
    if (!table)
        return false;
    free(mesh->table);
    mesh->table = table;
    mesh->table_room = room;
    for (int i = 0; i < room; i++)
        table[i] = -1;
    for (int i = 0; i < mesh->edge_count; i++)
        table[mesh_edge_slot(mesh, mesh->edges[i].a, mesh->edges[i].b)] = i;
    return true;
}

/* Edge between two nodes, created if necessary; -1 if memory runs out. */
static int need_edge(struct pp_mesh *mesh, int a, int b)
{
    int edge = mesh->table_room ? pp_mesh_edge(mesh, a, b) : -1;
    if (edge >= 0)
        return edge;
    if (!grow_table(mesh)
        || !reserve(&mesh->edges, &mesh->edge_room, mesh->edge_count,
                    sizeof *mesh->edges))
        return -1;
    int low = a < b ? a : b, high = a < b ? b : a;
    unsigned slot = mesh_edge_slot(mesh, low, high);
    mesh->edges[mesh->edge_count] = (struct pp_mesh_edge){low, high, {-1, -1}};
    mesh->table[slot] = mesh->edge_count;
    return mesh->edge_count++;
}

/* Replaces triangle `before` by `now` among the triangles of the edge a-b (-1:
 * none). */
static bool put_neighbour(struct pp_mesh *mesh, int a, int b, int before, int now)
{
    int edge = need_edge(mesh, a, b);
    if (edge < 0)
        return false;
    int *two = mesh->edges[edge].triangles;
    two[two[0] == before ? 0 : 1] = now;
    return true;
}

/* ---- construction ---- */

/* Node at a point, created if necessary; -1 if memory runs out. */
static int need_node(struct pp_mesh *mesh, const double xy[2])
{
    for (int i = 0; i < mesh->node_count; i++)
        if (mesh->nodes[i][0] == xy[0] && mesh->nodes[i][1] == xy[1])
            return i;
    if (!reserve(&mesh->nodes, &mesh->node_room, mesh->node_count, sizeof *mesh->nodes))
        return -1;
    mesh->nodes[mesh->node_count][0] = xy[0];
    mesh->nodes[mesh->node_count][1] = xy[1];
    return mesh->node_count++;
}

static bool add_contour_triangle(struct pp_mesh *mesh, int a, int b, int c)
{
    if (!reserve(&mesh->triangles, &mesh->triangle_room, mesh->triangle_count,
                 sizeof *mesh->triangles))
        return false;
    int new = mesh->triangle_count++;
    mesh->triangles[new][0] = a;
    mesh->triangles[new][1] = b;
    mesh->triangles[new][2] = c;
    return true;
}

static bool add_first(struct pp_mesh *mesh, const double corners[3][2])
{
    int nodes[3];
    for (int i = 0; i < 3; i++)
        if ((nodes[i] = need_node(mesh, corners[i])) < 0)
            return false;
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0])
        return true;
    int new = mesh->triangle_count;
    if (!add_contour_triangle(mesh, nodes[0], nodes[1], nodes[2]))
        return false;
    for (int i = 0; i < 3; i++)
        if (!put_neighbour(mesh, nodes[i], nodes[(i + 1) % 3], -1, new))
            return false;
    return true;
}

enum pp_status pp_mesh_init(struct pp_mesh *mesh, const struct pp_region *region,
                            struct pp_error *err)
{
    *mesh = (struct pp_mesh){0};
    struct pp_clipper *clipper;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status != PP_OK)
        return status;
    double(*corners)[3][2] = 0;
    int count = 0;
    status = pp_clipper_triangulate(clipper, &corners, &count, region, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        if (!add_first(mesh, (const double(*)[2])corners[i]))
            status = pp_fail_memory(err);
    free(corners);
    pp_clipper_destroy(clipper);
    if (status != PP_OK)
        pp_mesh_clear(mesh);
    return status;
}

/* ---- halving ---- */

static double length2(const struct pp_mesh *mesh, int a, int b)
{
    double dx = mesh->nodes[a][0] - mesh->nodes[b][0];
    double dy = mesh->nodes[a][1] - mesh->nodes[b][1];
    return dx * dx + dy * dy;
}

/* True if a-b is longer than c-d. Edges of equal length are ordered by their nodes;
 * otherwise halving might not terminate. */
static bool is_longer(const struct pp_mesh *mesh, int a, int b, int c, int d)
{
    double ab = a < b ? length2(mesh, a, b) : length2(mesh, b, a);
    double cd = c < d ? length2(mesh, c, d) : length2(mesh, d, c);
    if (ab != cd)
        return ab > cd;
    int ab_low = a < b ? a : b, cd_low = c < d ? c : d;
    return ab_low != cd_low ? ab_low < cd_low : a + b < c + d;
}

/* Index of the longest edge: 0 from corner 0 to 1, 1 from 1 to 2, 2 from 2 to 0. */
static int longest_side(const struct pp_mesh *mesh, int triangle)
{
    const int *t = mesh->triangles[triangle];
    int side = is_longer(mesh, t[1], t[2], t[0], t[1]) ? 1 : 0;
    return is_longer(mesh, t[2], t[0], t[side], t[side + 1]) ? 2 : side;
}

double pp_mesh_longest(const struct pp_mesh *mesh, int triangle)
{
    int side = longest_side(mesh, triangle);
    const int *t = mesh->triangles[triangle];
    return sqrt(length2(mesh, t[side], t[(side + 1) % 3]));
}

/* Halves triangle a b c at node m of its edge a-b. */
static bool split(struct pp_mesh *mesh, int triangle, int side, int m)
{
    int a = mesh->triangles[triangle][side];
    int b = mesh->triangles[triangle][(side + 1) % 3];
    int c = mesh->triangles[triangle][(side + 2) % 3];
    int new = mesh->triangle_count;
    if (!add_contour_triangle(mesh, m, b, c))
        return false;
    mesh->triangles[triangle][0] = a;
    mesh->triangles[triangle][1] = m;
    mesh->triangles[triangle][2] = c;
    return put_neighbour(mesh, b, c, triangle, new)
           && put_neighbour(mesh, a, m, -1, triangle)
           && put_neighbour(mesh, m, b, -1, new)
           && put_neighbour(mesh, m, c, -1, triangle)
           && put_neighbour(mesh, m, c, -1, new);
}

static int across(const struct pp_mesh *mesh, int triangle, int edge)
{
    const int *two = mesh->edges[edge].triangles;
    return two[0] == triangle ? two[1] : two[0];
}

enum pp_status pp_mesh_halve(struct pp_mesh *mesh, int triangle, struct pp_error *err)
{
    /* Follows the longest edges to a pair of triangles that share one, halves it, and
     * begins again until the triangle itself is halved. Each step goes to a longer
     * edge. */
    for (;;) {
        int here = triangle, neighbour, edge, side;
        for (;;) {
            side = longest_side(mesh, here);
            const int *t = mesh->triangles[here];
            edge = pp_mesh_edge(mesh, t[side], t[(side + 1) % 3]);
            assert(edge >= 0);
            neighbour = across(mesh, here, edge);
            if (neighbour < 0)
                break;
            int other = longest_side(mesh, neighbour);
            const int *n = mesh->triangles[neighbour];
            if (pp_mesh_edge(mesh, n[other], n[(other + 1) % 3]) == edge)
                break;
            here = neighbour;
        }

        int a = mesh->edges[edge].a, b = mesh->edges[edge].b;
        if (!reserve(&mesh->nodes, &mesh->node_room, mesh->node_count,
                     sizeof *mesh->nodes))
            return pp_fail_memory(err);
        int m = mesh->node_count++;
        for (int k = 0; k < 2; k++)
            mesh->nodes[m][k] = 0.5 * (mesh->nodes[a][k] + mesh->nodes[b][k]);
        mesh->edges[edge].triangles[0] = mesh->edges[edge].triangles[1] = -1;
        int other = neighbour >= 0 ? longest_side(mesh, neighbour) : 0;
        if (!split(mesh, here, side, m)
            || (neighbour >= 0 && !split(mesh, neighbour, other, m)))
            return pp_fail_memory(err);
        if (here == triangle || neighbour == triangle)
            return PP_OK;
    }
}
