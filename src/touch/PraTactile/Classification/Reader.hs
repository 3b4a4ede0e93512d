-- | All that is made of an alphabet of shapes, so that one value says which symbols are felt.
module PraTactile.Classification.Reader
  ( Reader (..),
    readerOf,
  )
where

import PraTactile.Classification.Estimate (Regression, standardRegression)
import PraTactile.Classification.Network (Network)
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
    readerRegression :: Regression
  }

-- | A reader of an alphabet by a network that was trained on it, as sure as that of GF(4)'s shapes
-- ('standardRegression'). Whether they have as many classes is for who uses them to ask.
readerOf :: Alphabet -> Network -> Reader
readerOf alphabet network =
  Reader
    { readerAlphabet = alphabet,
      readerTables = latticeTables alphabet,
      readerTemplates = templates alphabet,
      readerNetwork = network,
      readerRegression = standardRegression
    }
