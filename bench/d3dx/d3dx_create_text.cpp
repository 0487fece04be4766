// SPDX-License-Identifier: MIT
//
// D3DXCreateTextW, timed and kept: a Windows program, for Wine as for Windows itself.
//
//     d3dx_create_text text OUT RUNS FONT_FILE FAMILY      "Hello world!" at four deviations, RUNS times each
//     d3dx_create_text letters OUT FIRST FONT_FILE FAMILY  every letter of Latin-1 alone at more deviations, untimed
//     d3dx_create_text protocol TEXTS FIRST FONT_FILE FAMILY RUNS    the texts of bench_thesis, times only: rows (../README.md)
//
// Appends to OUT. The library is loaded by name (d3dx9_43.dll, or $D3DX9_DLL): what answers under Wine is Wine's own
// implementation, on Windows it is Microsoft's. Direct3DCreate9 wants a display; the device is of the kind NULLREF: it
// draws nothing.
//
// Wine's implementation crashes on some letters. Then the program prints the letter's number, its code and the
// deviation, and ends with 3; started again with the number after that as FIRST, it goes on behind it.

#include "measured_mesh.hpp"

#include <windows.h>

#include <d3d9.h>
#include <d3dx9.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace {

using create_text = HRESULT(WINAPI*)(IDirect3DDevice9*, HDC, const WCHAR*, float, float, ID3DXMesh**, ID3DXBuffer**,
                                     GLYPHMETRICSFLOAT*);

[[noreturn]] void fail(const char* what, long code = 0)
{
    std::fprintf(stderr, "%s failed (%lx)\n", what, static_cast<unsigned long>(code));
    std::exit(1);
}

std::wstring wide(const char* text)
{
    std::wstring out(std::strlen(text) + 1, L'\0');
    out.resize(static_cast<std::size_t>(
        MultiByteToWideChar(CP_UTF8, 0, text, -1, out.data(), static_cast<int>(out.size()) * 2)));
    out.pop_back();
    return out;
}

IDirect3DDevice9* make_device()
{
    IDirect3D9* d3d = Direct3DCreate9(D3D_SDK_VERSION);
    if (d3d == nullptr) fail("Direct3DCreate9");
    D3DPRESENT_PARAMETERS parameters = {};
    parameters.Windowed = TRUE;
    parameters.SwapEffect = D3DSWAPEFFECT_DISCARD;
    parameters.BackBufferWidth = parameters.BackBufferHeight = 16;
    parameters.BackBufferFormat = D3DFMT_X8R8G8B8;
    parameters.hDeviceWindow =
        CreateWindowW(L"STATIC", L"", WS_OVERLAPPEDWINDOW, 0, 0, 64, 64, nullptr, nullptr, nullptr, nullptr);
    IDirect3DDevice9* device = nullptr;
    const HRESULT made = d3d->CreateDevice(D3DADAPTER_DEFAULT, D3DDEVTYPE_NULLREF, parameters.hDeviceWindow,
                                           D3DCREATE_SOFTWARE_VERTEXPROCESSING, &parameters, &device);
    if (FAILED(made)) fail("CreateDevice", made);
    return device;
}

/// What the mesh holds, with 32-bit indices.
void take(ID3DXMesh* mesh, bench::measured_mesh& to)
{
    const DWORD stride = mesh->GetNumBytesPerVertex(), vertices = mesh->GetNumVertices(),
                indices = 3 * mesh->GetNumFaces();
    void* data = nullptr;
    if (FAILED(mesh->LockVertexBuffer(D3DLOCK_READONLY, &data))) fail("LockVertexBuffer");
    to.vertices.resize(vertices);
    for (DWORD i = 0; i < vertices; ++i)
        std::memcpy(to.vertices[i].data(), static_cast<const char*>(data) + i * stride, sizeof to.vertices[i]);
    mesh->UnlockVertexBuffer();
    if (FAILED(mesh->LockIndexBuffer(D3DLOCK_READONLY, &data))) fail("LockIndexBuffer");
    to.indices.resize(indices);
    const bool wide_indices = (mesh->GetOptions() & D3DXMESH_32BIT) != 0;
    for (DWORD i = 0; i < indices; ++i)
        to.indices[i] = wide_indices ? static_cast<const DWORD*>(data)[i] : static_cast<const WORD*>(data)[i];
    mesh->UnlockIndexBuffer();
}

char crash_note[64];

LONG WINAPI note_and_end(EXCEPTION_POINTERS*)
{
    DWORD written = 0;
    WriteFile(GetStdHandle(STD_OUTPUT_HANDLE), crash_note, static_cast<DWORD>(std::strlen(crash_note)), &written,
              nullptr);
    TerminateProcess(GetCurrentProcess(), 3);
    return 0;
}

/// Builds until half of 20 meshes take less than a millisecond each, for a minute at most: Wine's own processes, which it waits
/// for, start in the background.
template <class Build>
void settle(Build&& build)
{
    const auto start = std::chrono::steady_clock::now();
    std::vector<double> each;
    do {
        each.clear();
        for (int i = 0; i < 20; ++i) {
            const auto from = std::chrono::steady_clock::now();
            if (ID3DXMesh* mesh = build()) mesh->Release();
            each.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count());
        }
    } while (bench::median(each) > 1.0 && std::chrono::steady_clock::now() - start < std::chrono::minutes{1});
}

/// The texts of a file of lines "script, category, number, text", each at the four deviations of the thesis, from the FIRSTth
/// mesh on. "try N" stands before each mesh, "end" at the end: what is missing tells of a crash.
template <class Create>
void time_protocol(char** argv, Create&& create_mesh)
{
    std::ifstream in{argv[2], std::ios::binary};
    const int first = std::atoi(argv[3]), runs = std::atoi(argv[6]);
    int at = 0;
    settle([&] { return create_mesh(bench::hello.c_str(), bench::deviations[0]); });
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields{line};
        std::string script, category, number, utf8;
        std::getline(std::getline(std::getline(std::getline(fields, script, '\t'), category, '\t'), number, '\t'),
                     utf8);
        const std::wstring text = wide(utf8.c_str());
        for (const double deviation : bench::deviations) {
            if (at++ < first) continue;
            std::printf("try %d\n", at - 1);
            std::fflush(stdout);
            const auto build = [&] { return create_mesh(reinterpret_cast<const char16_t*>(text.c_str()), deviation); };
            ID3DXMesh* mesh = build();
            if (mesh == nullptr) continue;
            const DWORD vertices = mesh->GetNumVertices(), triangles = mesh->GetNumFaces();
            mesh->Release();
            double sum = 0;
            std::vector<double> each;
            for (int i = 0; i < runs; ++i) {
                const auto start = std::chrono::steady_clock::now();
                build()->Release();
                const std::chrono::duration<double, std::micro> one = std::chrono::steady_clock::now() - start;
                each.push_back(one.count());
                sum += one.count();
            }
            std::printf("d3dx\t%s\t%s\t%s\t%s\t%g\t%d\t%.3f\t%.3f\t%.3f\t%lu\t%lu\n", argv[5], script.c_str(),
                        category.c_str(), number.c_str(), deviation, runs, sum / runs, bench::median(each),
                        *std::min_element(each.begin(), each.end()), vertices, triangles);
            std::fflush(stdout);
        }
    }
    std::puts("end");
}

}  // namespace

int main(int argc, char** argv)
{
    const bool protocol = argc == 7 && std::strcmp(argv[1], "protocol") == 0;
    if (argc != 6 && !protocol)
        fail(
            "usage: d3dx_create_text text|letters OUT RUNS|FIRST FONT_FILE FAMILY, or protocol TEXTS FIRST FONT_FILE "
            "FAMILY RUNS");
    const bool letters = std::strcmp(argv[1], "letters") == 0;
    const std::string file = argv[2];
    const int number = std::atoi(argv[3]);
    SetUnhandledExceptionFilter(note_and_end);

    const char* name = std::getenv("D3DX9_DLL");
    const HMODULE library = LoadLibraryA(name != nullptr ? name : "d3dx9_43.dll");
    if (library == nullptr) fail("LoadLibrary");
    const auto create =
        reinterpret_cast<create_text>(reinterpret_cast<void*>(GetProcAddress(library, "D3DXCreateTextW")));
    if (create == nullptr) fail("GetProcAddress");
    const bool under_wine = GetProcAddress(GetModuleHandleA("ntdll.dll"), "wine_get_version") != nullptr;

    IDirect3DDevice9* device = make_device();
    const HDC dc = CreateCompatibleDC(nullptr);
    (void)AddFontResourceExW(wide(argv[4]).c_str(), FR_PRIVATE, nullptr);
    SelectObject(dc, CreateFontW(-1000, 0, 0, 0, FW_NORMAL, FALSE, FALSE, FALSE, DEFAULT_CHARSET, OUT_TT_PRECIS,
                                 CLIP_DEFAULT_PRECIS, DEFAULT_QUALITY, DEFAULT_PITCH, wide(argv[5]).c_str()));
    WCHAR face[LF_FACESIZE] = {};
    GetTextFaceW(dc, LF_FACESIZE, face);
    if (wide(argv[5]) != face) fail("the choice of the font: GDI took another one");

    if (protocol) {
        time_protocol(argv, [&](const char16_t* text, double deviation) {
            ID3DXMesh* mesh = nullptr;
            const auto* words = reinterpret_cast<const WCHAR*>(text);
            const HRESULT made =
                create(device, dc, words, static_cast<float>(deviation), 0.3f, &mesh, nullptr, nullptr);
            return SUCCEEDED(made) ? mesh : nullptr;
        });
        return 0;
    }

    std::FILE* out = std::fopen(file.c_str(), "ab");
    if (out == nullptr) fail("fopen");
    const auto mesh_of = [&](const std::u16string& text, double deviation) {
        ID3DXMesh* mesh = nullptr;
        const HRESULT made = create(device, dc, reinterpret_cast<const WCHAR*>(text.c_str()),
                                    static_cast<float>(deviation), 0.3f, &mesh, nullptr, nullptr);
        return SUCCEEDED(made) ? mesh : nullptr;
    };
    bench::measured_mesh m;
    m.maker = under_wine ? "Wine's D3DXCreateTextW" : "D3DXCreateTextW of Windows";
    m.font = bench::name_of(argv[4]);
    const auto keep = [&](const std::u16string& text, double deviation) {
        ID3DXMesh* mesh = mesh_of(text, deviation);
        if (mesh == nullptr) return;  // blank, or what it does not make
        m.text = text, m.deviation = deviation;
        take(mesh, m);
        mesh->Release();
        if (!bench::write(out, m)) fail("fwrite");
        std::fflush(out);
    };

    if (letters) {
        int at = 0;
        for (const double deviation : bench::letter_deviations)
            for (const char16_t letter : bench::latin_letters()) {
                if (at++ < number) continue;
                std::snprintf(crash_note, sizeof crash_note, "%d U+%04X %g\n", at - 1, static_cast<unsigned>(letter),
                              deviation);
                keep(std::u16string(1, letter), deviation);
            }
    } else {
        for (const double deviation : bench::deviations) {
            const auto times = bench::time_of(number, [&] {
                ID3DXMesh* mesh = mesh_of(bench::hello, deviation);
                if (mesh == nullptr) fail("D3DXCreateTextW");
                mesh->Release();
            });
            m.microseconds = times.median, m.best = times.best;
            keep(bench::hello, deviation);
        }
    }
    std::fclose(out);
}
