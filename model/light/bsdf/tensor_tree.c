/* tensor_tree.c - see tensor_tree.h. The text is read twice: for its depth, then for
 * its values. */
#include "model/light/bsdf/tensor_tree.h"

#include <stdlib.h>

#include "model/light/bsdf/number_list.h"

enum {
    RANK_MOST = 4,
    LEVELS_MOST = 10,
    GRID_LEVELS_MOST = 5,
    SIDE_MOST = 32,
    ISOTROPIC_SIDE_MOST = 16
};

struct tree_reader {
    const char *at;
    int rank;
    int side;      /* cells per coordinate; 0: finds only `levels` */
    double *cells; /* values; the first coordinate varies slowest */
    int levels;
    struct pp_number_list numbers; /* numbers in the current brace */
    const char *fault;
};

/* A node covers [low, low + size) of each coordinate, in cells. */
struct tree_node {
    double low[RANK_MOST], size;
    int level;
};

static bool fails(struct tree_reader *r, const char *fault)
{
    r->fault = fault;
    return false;
}

/* Moves on to the next character that is neither white nor a comma. */
static char next_sign(struct tree_reader *r)
{
    r->at = pp_number_list_skip(r->at);
    return *r->at;
}

/* Sets the cells of a node. A node smaller than a cell adds its value, weighted by its
 * share of the cell. */
static void set_cells(const struct tree_reader *r, const struct tree_node *node,
                      double value)
{
    int width = node->size > 1.0 ? (int)node->size : 1, count = 1;
    double share = node->size < 1.0 ? pow(node->size, r->rank) : 1.0;
    for (int k = 0; k < r->rank; k++)
        count *= width;
    for (int i = 0; i < count; i++) {
        int at = 0;
        for (int k = 0, left = i; k < r->rank; k++, left /= width)
            at = at * r->side + (int)node->low[k] + left % width;
        r->cells[at] += share * fmax(0.0, value);
    }
}

/* Reads the numbers up to the closing brace. */
static bool read_numbers(struct tree_reader *r, const struct tree_node *node)
{
    r->numbers.count = 0;
    if (!pp_number_list_read(&r->numbers, &r->at, 1 << (r->rank * GRID_LEVELS_MOST)))
        return fails(r, "braces contain text that is not a number, or too many "
                        "values");
    int level = 0;
    while (level < GRID_LEVELS_MOST && r->numbers.count > 1 << (r->rank * level))
        level++;
    if (r->numbers.count != 1 << (r->rank * level))
        return fails(r, r->rank == 4
                            ? ("the number of values between braces is not a power of "
                               "16; expected 1, 16, 256, ...")
                            : ("the number of values between braces is not a power of "
                               "8; expected 1, 8, 64, ..."));
    if (node->level + level > r->levels)
        r->levels = node->level + level;
    if (r->side == 0)
        return true;
    int side = 1 << level;
    struct tree_node part = {.size = node->size / side};
    for (int i = 0; i < r->numbers.count; i++) {
        for (int k = r->rank - 1, left = i; k >= 0; k--, left /= side)
            part.low[k] = node->low[k] + left % side * part.size;
        set_cells(r, &part, r->numbers.list[i]);
    }
    return true;
}

static bool read_node(struct tree_reader *r, const struct tree_node *node)
{
    if (next_sign(r) != '{')
        return fails(r, "an opening brace is missing");
    if (node->level > LEVELS_MOST)
        return fails(r, "braces are nested more than 10 levels deep");
    r->at++;
    if (next_sign(r) != '{') {
        if (!read_numbers(r, node))
            return false;
    } else {
        for (int i = 0; i < 1 << r->rank; i++) {
            struct tree_node child = {.size = 0.5 * node->size,
                                      .level = node->level + 1};
            for (int k = 0; k < r->rank; k++)
                child.low[k] = node->low[k] + (i >> k & 1) * child.size;
            if (!read_node(r, &child))
                return false;
        }
    }
    if (next_sign(r) != '}')
        return fails(r, "a closing brace is missing");
    r->at++;
    return true;
}

static bool read_tree(struct tree_reader *r, const char *text)
{
    const struct tree_node root = {.size = r->side};
    r->at = text;
    return read_node(r, &root)
           && (next_sign(r) == '\0' || fails(r, "text follows the tree"));
}

/* Value of a tree of rank 3 for a pair of directions. */
static double isotropic_value(const struct tree_reader *r, struct pp_vec3 arrives,
                              struct pp_vec3 leaves)
{
    struct pp_angle_basis fine = pp_angle_basis_grid(r->side);
    double sine = hypot(arrives.x, arrives.y);
    double c = sine > 0.0 ? arrives.x / sine : 1.0;
    double s = sine > 0.0 ? arrives.y / sine : 0.0;
    struct pp_vec3 turned =
        pp_vec(c * leaves.x + s * leaves.y, c * leaves.y - s * leaves.x, leaves.z);
    int slice = (int)(0.5 * (1.0 - sine) * r->side);
    return r->cells[slice * fine.count + pp_angle_basis_find(&fine, turned)];
}

/* Mean over directions of both patches, for a tree of rank 3. */
static double isotropic_mean(const struct tree_reader *r,
                             const struct pp_angle_basis *grid, int in, int out)
{
    enum { PARTS = 2, PLACES = PARTS * PARTS };
    double sum = 0.0;
    for (int i = 0; i < PLACES * PLACES; i++) {
        int a = i / PLACES, b = i % PLACES;
        sum += isotropic_value(
            r,
            pp_angle_basis_direction(grid, in, (a / PARTS + 0.5) / PARTS,
                                     (a % PARTS + 0.5) / PARTS),
            pp_angle_basis_direction(grid, out, (b / PARTS + 0.5) / PARTS,
                                     (b % PARTS + 0.5) / PARTS));
    }
    return sum / (PLACES * PLACES);
}

/* Makes a block from the cells. */
static enum pp_status fill_block(struct pp_bsdf_block *block,
                                 const struct tree_reader *r, struct pp_error *err)
{
    int side =
        r->rank == 3 && r->side > ISOTROPIC_SIDE_MOST ? ISOTROPIC_SIDE_MOST : r->side;
    struct pp_angle_basis grid = pp_angle_basis_grid(side);
    block->in = block->out = grid;
    enum pp_status status = pp_bsdf_block_init(block, err);
    for (int out = 0; status == PP_OK && out < grid.count; out++)
        for (int in = 0; in < grid.count; in++)
            block->values[out * grid.count + in] =
                r->rank == 4 ? r->cells[in * grid.count + out]
                             : isotropic_mean(r, &grid, in, out);
    return status;
}

enum pp_status pp_tensor_tree_read(struct pp_bsdf_block *block, const char *text,
                                   int rank, const char **fault, struct pp_error *err)
{
    struct tree_reader r = {.rank = rank};
    enum pp_status status = PP_OK;
    *fault = NULL;
    if (read_tree(&r, text)) {
        size_t count = 1;
        r.side = 1 << r.levels < SIDE_MOST ? 1 << r.levels : SIDE_MOST;
        for (int k = 0; k < rank; k++)
            count *= (size_t)r.side;
        r.cells = calloc(count, sizeof *r.cells);
        if (r.cells && read_tree(&r, text))
            status = fill_block(block, &r, err);
        else
            status = pp_fail_memory(err);
    }
    *fault = r.fault;
    if (r.numbers.out_of_memory)
        status = pp_fail_memory(err);
    free(r.cells);
    free(r.numbers.list);
    return status;
}
