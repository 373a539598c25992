/* bsdf_write.c - see bsdf_write.h. */
#include "model/light/bsdf/bsdf_write.h"

#include "model/light/bsdf/angle_basis.h"

#define BASIS_NAME "pepperpot"

static void write_rings(FILE *out, const struct pp_angle_basis *basis)
{
    fputs("<AngleBasis><AngleBasisName>" BASIS_NAME "</AngleBasisName>\n", out);
    for (int i = 0; i < basis->ring_count; i++) {
        const struct pp_angle_ring *ring = &basis->rings[i];
        double low = ring->low_rad / PP_RAD, high = ring->high_rad / PP_RAD;
        fprintf(out,
                "<AngleBasisBlock><Theta>%.9g</Theta><nPhis>%d</nPhis><ThetaBounds>"
                "<LowerTheta>%.9g</LowerTheta><UpperTheta>%.9g</UpperTheta>"
                "</ThetaBounds></AngleBasisBlock>\n",
                i == 0 ? 0.0 : 0.5 * (low + high), ring->patches, low, high);
    }
    fputs("</AngleBasis>\n", out);
}

/* BSDF of light that travels in these patches, into the room (way 1) or out (-1). */
static double bsdf_value(const struct pp_pane_scatter *scatter,
                         const struct pp_angle_basis *basis, int in, int leaving,
                         double way)
{
    struct pp_vec3 from = pp_angle_basis_direction(basis, in, 0.5, 0.5);
    struct pp_vec3 to = pp_angle_basis_direction(basis, leaving, 0.5, 0.5);
    from.z *= way;
    to.z *= way;
    double f = scatter->btdf(scatter->data, from, to);
    if (in == leaving)
        f += scatter->straight(scatter->data, from)
             / pp_angle_basis_projected(basis, leaving);
    return f;
}

/* Writes the values row by row. A row of a tree has all leaving patches for one
 * arriving patch; a row of a matrix has all arriving patches for one leaving patch. */
static void write_values(FILE *out, const struct pp_pane_scatter *scatter,
                         const struct pp_angle_basis *basis, double scale, double way)
{
    bool tree = basis->side > 0;
    if (tree)
        fputs("{\n", out);
    for (int row = 0; row < basis->count; row++)
        for (int i = 0; i < basis->count; i++)
            fprintf(
                out, "%.7g%s",
                scale * bsdf_value(scatter, basis, tree ? row : i, tree ? i : row, way),
                i + 1 < basis->count ? " " : "\n");
    if (tree)
        fputs("}\n", out);
}

void pp_bsdf_write(FILE *out, const struct pp_pane_scatter *scatter, double scale,
                   const char *name)
{
    struct pp_angle_basis full;
    const struct pp_angle_basis *basis = scatter->basis;
    if (!basis) {
        pp_angle_basis_named(&full, "LBNL/Klems Full");
        basis = &full;
    }
    bool tree = basis->side > 0;
    fprintf(
        out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<WindowElement xmlns=\"http://windows.lbl.gov\">\n"
        "<WindowElementType>System</WindowElementType>\n<FileType>BSDF</FileType>\n"
        "<Optical>\n<Layer>\n<Material><Name>%s</Name></Material>\n<DataDefinition>\n"
        "<IncidentDataStructure>%s</IncidentDataStructure>\n",
        name, tree ? "TensorTree4" : "Columns");
    if (!tree)
        write_rings(out, basis);
    fputs("</DataDefinition>\n", out);
    for (int way = 1; way >= -1; way -= 2) {
        fprintf(out,
                "<WavelengthData>\n<LayerNumber>System</LayerNumber>\n"
                "<Wavelength unit=\"Integral\">Visible</Wavelength>\n"
                "<WavelengthDataBlock>\n<WavelengthDataDirection>Transmission %s"
                "</WavelengthDataDirection>\n",
                way > 0 ? "Front" : "Back");
        fputs(tree ? "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>\n"
                   : "<ColumnAngleBasis>" BASIS_NAME "</ColumnAngleBasis>\n"
                     "<RowAngleBasis>" BASIS_NAME "</RowAngleBasis>\n",
              out);
        fputs("<ScatteringDataType>BTDF</ScatteringDataType>\n<ScatteringData>\n", out);
        write_values(out, scatter, basis, scale, way);
        fputs("</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n", out);
    }
    fputs("</Layer>\n</Optical>\n</WindowElement>\n", out);
}
