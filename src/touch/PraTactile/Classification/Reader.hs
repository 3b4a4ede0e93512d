-- | A symbol alphabet together with everything derived from it.
module PraTactile.Classification.Reader
  ( Reader (..),
    readerOf,
  )
where

import PraTactile.Classification.Calibration (Calibration, standardCalibration)
import PraTactile.Classification.Network (Network, outputCount)
import PraTactile.Classification.Templates (Templates, templates)
import PraTactile.Registration.Lattice.Template (LatticeTables, latticeTables)
import PraTactile.Shape (Alphabet)

-- | The shapes of an alphabet and what is derived from them, each part computed once, on first
-- use. Pressing, registration and recognition all take their shapes from one 'Reader', so they use
-- the same alphabet.
data Reader = Reader
  { -- | the shapes, by class
    readerAlphabet :: Alphabet,
    -- | the tables that registration compares frames with
    readerTables :: LatticeTables,
    -- | the templates that images of symbols and parts are compared with
    readerTemplates :: Templates,
    -- | the network that was trained on the shapes, one output per class
    readerNetwork :: Network,
    -- | turns the network's outputs into probabilities
    readerCalibration :: Calibration
  }

-- | The reader for an alphabet and a network that was trained on it, with 'standardCalibration'.
-- It does not check that both have the same number of classes.
readerOf :: Alphabet -> Network -> Reader
readerOf alphabet network =
  Reader
    { readerAlphabet = alphabet,
      readerTables = latticeTables alphabet,
      readerTemplates = templates alphabet,
      readerNetwork = network,
      readerCalibration = standardCalibration (outputCount network)
    }
