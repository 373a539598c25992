# make_prism.awk - writes prism.xml: a prismatic sheet that sends light from the sky up to
# the ceiling, as a matrix over Klems's quarter basis in a WINDOW XML file.
#
#     awk -f make_prism.awk >prism.xml
#
# These are not measured data. Light that travels downwards: 20 % passes straight, 45 % leaves
# upwards at the same angle; other light: 30 % and 20 %. A further 10 % is spread evenly.

BEGIN {
    pi = atan2(0, -1)
    rings = split("9 27 45 63 90", upper)
    split("1 8 12 12 8", patches)
    low = 0
    for (r = 1; r <= rings; r++) {
        for (k = 0; k < patches[r]; k++) {
            azimuth[n] = 360 * k / patches[r]
            # The patch of light whose vertical direction is reversed.
            mirrored[n] = n - k + (patches[r] - k) % patches[r]
            # Projected solid angle.
            W[n++] = pi * (sine(upper[r]) ^ 2 - sine(low) ^ 2) / patches[r]
        }
        low = upper[r]
    }
    print "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
    print "<WindowElement xmlns=\"http://windows.lbl.gov\">"
    print "<WindowElementType>System</WindowElementType><FileType>BSDF</FileType>"
    print "<Optical><Layer>"
    print "<Material><Name>prismatic sheet (example)</Name></Material>"
    print "<DataDefinition><IncidentDataStructure>Columns</IncidentDataStructure></DataDefinition>"
    block("Transmission Front")
    print "</Layer></Optical>"
    print "</WindowElement>"
}

function sine(degrees)
{
    return sin(degrees * pi / 180)
}

# Each line is one patch of leaving light; along the line, the patches of arriving light.
function block(direction,    out, i, f)
{
    print "<WavelengthData><Wavelength unit=\"Integral\">Visible</Wavelength><WavelengthDataBlock>"
    print "<WavelengthDataDirection>" direction "</WavelengthDataDirection>"
    print "<ColumnAngleBasis>LBNL/Klems Quarter</ColumnAngleBasis>"
    print "<RowAngleBasis>LBNL/Klems Quarter</RowAngleBasis>"
    print "<ScatteringDataType>BTDF</ScatteringDataType>"
    print "<ScatteringData>"
    for (out = 0; out < n; out++) {
        for (i = 0; i < n; i++) {
            down = azimuth[i] > 180 && azimuth[i] < 360
            f = 0.1 / pi
            if (out == i)
                f += (down ? 0.2 : 0.3) / W[out]
            if (out == mirrored[i])
                f += (down ? 0.45 : 0.2) / W[out]
            printf "%.5g%s", f, i < n - 1 ? " " : "\n"
        }
    }
    print "</ScatteringData>"
    print "</WavelengthDataBlock></WavelengthData>"
}
