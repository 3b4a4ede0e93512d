-- | All that is made of an alphabet of shapes, so that one value says which symbols are felt.
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

-- | What symbols are read with: their shapes, and what is made of these, each part once, when it is
-- first looked at. Everything that presses, puts frames together or reads them takes its shapes
-- from here, and so from one alphabet.
data Reader = Reader
  { -- | the shapes, by class
    readerAlphabet :: Alphabet,
    -- | what frames are held against when they are put together
    readerTables :: LatticeTables,
    -- | what images of symbols and parts are held against
    readerTemplates :: Templates,
    -- | the network that was trained on the shapes, with an output a class
    readerNetwork :: Network,
    -- | how sure its estimates are
    readerCalibration :: Calibration
  }

-- | A reader of an alphabet by a network that was trained on it, as sure as 'standardCalibration'
-- has it. Whether they have as many classes is for who uses them to ask.
readerOf :: Alphabet -> Network -> Reader
readerOf alphabet network =
  Reader
    { readerAlphabet = alphabet,
      readerTables = latticeTables alphabet,
      readerTemplates = templates alphabet,
      readerNetwork = network,
      readerCalibration = standardCalibration (outputCount network)
    }
