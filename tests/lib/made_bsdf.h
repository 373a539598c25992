/* made_bsdf.h - builds WINDOW XML files for tests, from formulae. */
#ifndef PP_TESTS_LIB_MADE_BSDF_H
#define PP_TESTS_LIB_MADE_BSDF_H

#include <stdio.h>
#include <stdlib.h>

#include "model/light/bsdf/bsdf_file.h"

/* BSDF, 1/sr, of light that arrives and leaves in these patches of a basis. */
typedef double made_bsdf_law(const struct pp_angle_basis *basis, int in, int out);

/* A file under construction; free(text) after made_bsdf_end. The struct must not move. */
struct made_bsdf {
    char *text;
    size_t length;
    FILE *out;
};

static inline void made_bsdf_begin(struct made_bsdf *file, const char *layout)
{
    file->out = open_memstream(&file->text, &file->length);
    fprintf(file->out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<WindowElement xmlns=\"http://windows.lbl.gov\">\n<Optical>\n<Layer>\n"
            "<Material><Name>made pane</Name></Material>\n<DataDefinition>"
            "<IncidentDataStructure>%s</IncidentDataStructure></DataDefinition>\n",
            layout);
}

static inline void made_bsdf_end(struct made_bsdf *file)
{
    fprintf(file->out, "</Layer>\n</Optical>\n</WindowElement>\n");
    fclose(file->out);
}

static inline void made_bsdf_block_begin(struct made_bsdf *file, const char *band,
                                         const char *direction, const char *basis)
{
    fprintf(file->out,
            "<WavelengthData><Wavelength>%s</Wavelength><WavelengthDataBlock>\n"
            "<WavelengthDataDirection>%s</WavelengthDataDirection>\n"
            "<ColumnAngleBasis>%s</ColumnAngleBasis><RowAngleBasis>%s</RowAngleBasis>\n"
            "<ScatteringData>\n",
            band, direction, basis, basis);
}

static inline void made_bsdf_block_end(struct made_bsdf *file)
{
    fprintf(file->out, "</ScatteringData></WavelengthDataBlock></WavelengthData>\n");
}

/* A block of columns: each line is one leaving patch. */
static inline void made_bsdf_block(struct made_bsdf *file, const char *direction,
                                   const char *name, made_bsdf_law *law)
{
    struct pp_angle_basis basis;
    pp_angle_basis_named(&basis, name);
    made_bsdf_block_begin(file, "Visible", direction, name);
    for (int out = 0; out < basis.count; out++)
        for (int in = 0; in < basis.count; in++)
            fprintf(file->out, "%.9g%s", law(&basis, in, out),
                    in + 1 < basis.count ? "," : "\n");
    made_bsdf_block_end(file);
}

/* A file of one block of transmission from outside. */
static inline struct made_bsdf made_bsdf_front(const char *basis, made_bsdf_law *law)
{
    struct made_bsdf file;
    made_bsdf_begin(&file, "Columns");
    made_bsdf_block(&file, "Transmission Front", basis, law);
    made_bsdf_end(&file);
    return file;
}

/* Patch of light whose direction is mirrored in the horizontal plane through the
 * normal. */
static inline int made_bsdf_mirrored(const struct pp_angle_basis *basis, int patch)
{
    struct pp_vec3 d = pp_angle_basis_direction(basis, patch, 0.5, 0.5);
    return pp_angle_basis_find(basis, pp_vec(d.x, -d.y, d.z));
}

/* A prismatic sheet: of light that travels down, 0.25 passes straight and 0.45 is sent up
 * at the same angle; of other light 0.25 and 0.15. A further 0.1 is spread, three times as
 * much towards +x as towards -x. */
static inline double made_bsdf_prism(const struct pp_angle_basis *basis, int in,
                                     int out)
{
    struct pp_vec3 d = pp_angle_basis_direction(basis, in, 0.5, 0.5);
    struct pp_vec3 to = pp_angle_basis_direction(basis, out, 0.5, 0.5);
    if (out == 0)
        to.x = 0.0; /* the cap about the normal */
    double W = pp_angle_basis_projected(basis, out);
    double f = 0.1 / PP_PI * (to.x > 1e-9 ? 1.5 : to.x < -1e-9 ? 0.5 : 1.0);
    if (out == in)
        f += 0.25 / W;
    if (out == made_bsdf_mirrored(basis, in))
        f += (d.y < -1e-9 ? 0.45 : 0.15) / W;
    return f;
}

static inline double made_bsdf_lambertian(const struct pp_angle_basis *basis, int in,
                                          int out)
{
    (void)basis, (void)in, (void)out;
    return 0.4 / PP_PI;
}

#endif
