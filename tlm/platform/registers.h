#pragma once

#include <cstdint>

namespace repousse::shell {

/// The device's registers: 32 bits each, at byte offset 4 * index. Two neighbours form a 64-bit
/// value, low word first, where the name ends in Lo. All from kFeatures to kFrameEnd belong to a
/// frame: what is written is latched when the frame starts, so the next frame can be prepared while
/// one runs.
enum Register : uint32_t {
    kId,         ///< read only: kIdValue
    kControl,    ///< the ControlBits
    kDoorbell,   ///< write kStart or kDrained
    kStatus,     ///< read only: the StatusBits
    kInterrupt,  ///< write 1: acknowledge
    kErrorCode,  ///< read only: why kStatusError is set, a FrameError

    kFeatures,           ///< the Features
    kCap,                ///< generation cap, 0 to 15
    kViewThreshold,      ///< raw, fraction bits of `screen`
    kNormalThreshold,    ///< raw `displaced_normal`
    kHeightThresholdLo,  ///< height LSB, or height LSB x texel^2
    kHeightThresholdHi,
    kMapWidth,  ///< texels
    kMapHeight,
    kScaleMantissa,  ///< D = h * mantissa * 2^-exponent + bias
    kScaleExponent,
    kBias,                 ///< raw `displacement`
    kEye,                  ///< three words, raw `position`
    kRight = kEye + 3,     ///< three words, raw `view_row`
    kUp = kRight + 3,      ///< three words
    kForward = kUp + 3,    ///< three words
    kNear = kForward + 3,  ///< raw `clip`
    kFocalX,               ///< raw `focal`
    kFocalY,
    kCentreX,
    kCentreY,
    kVertexCount,
    kTriangleCount,
    kOutputCapacity,  ///< triangles that fit the output buffer
    kVerticesLo,      ///< address of VertexRecord[]
    kVerticesHi,
    kIndicesLo,  ///< address of uint32_t[3 * triangles]; sweep: of SweepRecord[triangles]
    kIndicesHi,
    kHeightsLo,  ///< address of uint16_t[width * height]; with filter levels: level_start()
    kHeightsHi,
    kNormalsLo,  ///< address of int16_t[3 * width * height]; bump of kind 2: [2 * width * height]
    kNormalsHi,
    kSumsLo,  ///< address of uint64_t[(width + 1) * (height + 1)]
    kSumsHi,
    kOutputLo,  ///< address of OutputRecord[]; sweep: of FineTriangleRecord[]
    kOutputHi,

    // Sweep-line remeshing.
    kGridFocalX,  ///< raw `focal`: grid units per unit of x/w
    kGridFocalY,
    kWMin,            ///< raw `clip`, > 0
    kWScale,          ///< raw `clip`, >= kWMin
    kStepsPerOctave,  ///< raw `steps_per_octave`
    kLog2Near,        ///< s6.20
    kZTableNear,      ///< raw `clip`; this and the next four: the uniform depth table only
    kZTableScale,     ///< 2^19 .. 2^20 - 1
    kZTableShift,     ///< 0 .. 63
    kZTableLo,        ///< address of uint32_t[2^z_table_index_bits + 1]
    kZTableHi,
    kGuard,        ///< clamp of corners, grid units, 1 to 4096
    kZOffset,      ///< grid units, s14
    kClipNear,     ///< raw `clip`
    kClipFar,      ///< raw `clip`
    kClipCosineX,  ///< raw `view_row`, with the next three the planes at the sides
    kClipSineX,
    kClipCosineY,
    kClipSineY,
    kClipMargin,            ///< raw `clip`
    kOutputVertexCapacity,  ///< vertices that fit their output buffer
    kOutputVerticesLo,      ///< address of FineRecord[]
    kOutputVerticesHi,
    kLastLevel,  ///< filter levels behind the map, 0 to 14; kMaximum or kAverage only
    kFiner,      ///< levels below that of a footprint, 0 to 2; kMaximum only

    // Bump of kind 1: a slope is a rise of heights over two texels * mantissa * 2^-exponent.
    kSlopeUMantissa,
    kSlopeUExponent,
    kSlopeVMantissa,
    kSlopeVExponent,

    // Illumination.
    kAmbient,                   ///< three words, raw `light`: red, green, blue
    kShininess = kAmbient + 3,  ///< 1 to 255
    kLights,                    ///< eight times direction, raw `normal`; diffuse, specular, `light`
    kFrameEnd = kLights + 72,

    kOutputCount = kFrameEnd,  ///< read only: triangles in the output buffer
    kOutputVertexCount,        ///< read only: vertices in their output buffer
    kCyclesLo,                 ///< read only: cycles since the last reset
    kCyclesHi,
    kRegisterCount,
};

inline constexpr uint32_t kIdValue = 0x52505331;  ///< "RPS1"

enum ControlBit : uint32_t {
    kControlInterrupts = 1,  ///< enabled
    kControlReset = 2,       ///< to the power-on state, self-clearing; ignored while busy
    kControlAbort = 4,       ///< end the frame that runs, self-clearing
};

enum Doorbell : uint32_t {
    kStart = 1,    ///< run a frame
    kDrained = 2,  ///< the host has emptied the output buffer
};

enum StatusBit : uint32_t {
    kStatusBusy = 1,
    kStatusDone = 2,        ///< the frame is complete
    kStatusOutputFull = 4,  ///< waits for kDrained
    kStatusError = 8,       ///< the frame was not run, or not to its end
    kStatusRunaway = 16,    ///< the sweep line gave a triangle up; until reset
    kStatusBadRef = 32,     ///< the stripping unit was asked for a vertex it has not; until reset
};

enum FrameError : uint32_t {
    kNoError,
    kMissingUnit,    ///< a feature needs a unit that this device was built without
    kBadRegister,    ///< a register is out of its range
    kMemoryError,    ///< an access was answered with an error
    kStackOverflow,  ///< the stack's bound did not hold
    kBadIndex,       ///< an index names no vertex
    kAborted,        ///< by kControlAbort
    kBadDescriptor,  ///< a base triangle's displacement or flags are out of range
};

enum Feature : uint32_t {
    kUseViewTest = 1 << 0,
    kUseNormalTest = 1 << 1,
    kUseHeightTest = 1 << 2,
    kUseBump = 1 << 3,
    kEager = 1 << 4,
    kFifo = 1 << 5,
    kMapSpaceNormals = 1 << 6,
    kLiteralBoxes = 1 << 7,
    kSumMode = 1 << 8,
    kWrap = 1 << 9,
    kBilinear = 1 << 10,
    kSweep = 1 << 11,    ///< sweep-line remeshing instead of adaptive tessellation
    kUseClip = 1 << 12,  ///< sweep: clip base triangles
    kUseShade = 1 << 13,
    kTwoSided = 1 << 14,  ///< shade: the surface is lit as the viewer sees it from either side
    kMaximum = 1 << 15,   ///< sweep: heights are the highest under a footprint; before kAverage
    kAverage = 1 << 16,   ///< sweep: heights are averages under a footprint; before kBilinear
    kMinima = 1 << 17,    ///< sweep: filter levels have minima of their own
};

}  // namespace repousse::shell
