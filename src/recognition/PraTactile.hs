-- | pra-tactile: a reference decoder for objects whose faces carry a pseudorandom array of embossed
-- symbols (Petriu, Yeung, Das, Cretu and Spoelder, IEEE Trans. Instrum. Meas. 53(5), 2004).
--
-- This module collects the main functions in reading order; the modules that it takes them from
-- have the rest. With the standard choices, 'canonicalRecogniser' makes a recogniser,
-- 'decodeFolder' or 'decodeImage' decodes bytes, and 'summary' describes the result. With choices
-- of your own, 'shippedReader', or 'readerOf' an alphabet and a network, makes a reader; a reader,
-- a placement and an array make a 'recogniser'; 'stitch' makes a composite of frames; and
-- 'recognise' reads it.
module PraTactile
  ( -- * Decoding: "PraTactile.Decode", "PraTactile.Source"
    SomeRecogniser,
    canonicalRecogniser,
    decodeFolder,
    decodeImage,
    decodeFrames,
    Decoding (..),
    standardDecoding,
    decodeSources,
    DecodeError (..),
    Source (..),
    Folder (..),
    folderFrames,
    Preparation (..),
    asStated,
    preparedFrames,
    Stitching (..),
    standardStitching,
    imageComposite,
    SourceError (..),
    summary,

    -- * The array: "PraTactile.Profile", "PraTactile.Array"
    Profile (..),
    canonicalProfile,
    withProfile,
    PseudorandomArray,
    Shape (..),
    Position (..),
    Surface (..),
    ArrayOn (..),
    naturally,
    cellAt,

    -- * Its window property: "PraTactile.Window.Proof"
    Mask,
    rectangle,
    prove,
    WindowVerdict (..),
    Proved,

    -- * Locating: "PraTactile.Locate"
    Query (..),
    onePatch,
    Patch,
    patch,
    Cell (..),
    Locator,
    locator,
    locate,
    answerOutcome,
    Outcome (..),
    Candidate (..),
    Reason (..),

    -- * Images of touch: "PraTactile.Image", "PraTactile.Sensor.Frame", "PraTactile.Registration"
    Raster,
    Frame (..),
    SensorPose (..),
    Composite,
    LatticeTables,
    latticeTables,
    stitch,
    standardRegistration,
    compositeOf,

    -- * Objects: "PraTactile.Object.Placement"
    Placement,
    canonicalPlacement,
    platePlacement,
    whereabouts,
    Whereabouts (..),
    Place (..),

    -- * Recognition: "PraTactile.Recognise"
    Reader (..),
    readerOf,
    shippedReader,
    ShippedError (..),
    Recogniser,
    recogniser,
    recognise,
    recogniseWith,
    recognisedAngle,
    Tolerance (..),
    standardTolerance,
    Recognition (..),
    Support (..),
    Doubts (..),
    supportDoubt,
    Identification (..),
    Finding (..),
    Refusal (..),
  )
where

import PraTactile.Array
import PraTactile.Classification.Reader
import PraTactile.Classification.Shipped
import PraTactile.Decode
import PraTactile.Image (Raster)
import PraTactile.Locate
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement
import PraTactile.Object.Plate (platePlacement)
import PraTactile.Profile
import PraTactile.Recognise
import PraTactile.Recognise.Summary (summary)
import PraTactile.Registration
import PraTactile.Sensor.Frame
import PraTactile.Source
import PraTactile.Window
import PraTactile.Window.Proof
