-- | The alphabet of the paper's array and its network, and frames registered with it. Tests of
-- touch use them unless they are about shapes.
module Test.Touch.Paper
  ( paperAlphabet,
    paperNetwork,
    paperReader,
    paperTables,
    arrange,
    assemble,
    stitch,
    stitchedBy,
  )
where

import PraTactile.Classification.Network (Network)
import PraTactile.Classification.Reader (Reader (..), readerOf)
import PraTactile.Classification.Shipped
import PraTactile.Composite.Blend (Taxels)
import PraTactile.Image (Raster)
import PraTactile.Registration (Assembly, Composite, StitchError)
import qualified PraTactile.Registration as Registration
import PraTactile.Registration.Arrangement (Arrangement, StitchMethod, TooMuch)
import qualified PraTactile.Registration.Arrangement as Arrangement
import PraTactile.Registration.Lattice.Fit (whole)
import PraTactile.Registration.Lattice.Template (LatticeTables)
import PraTactile.Registration.Settings (Registration)
import PraTactile.Registration.Stitching (Stitching)
import qualified PraTactile.Registration.Stitching as Stitching
import PraTactile.Sensor.Frame (Frame)
import PraTactile.Shape (Alphabet)

paperAlphabet :: Either ShippedError Alphabet
paperAlphabet = shippedAlphabet 4

paperNetwork :: Either ShippedError Network
paperNetwork = shippedNetwork 4

-- | The symbols' shapes and network, and what is computed from them, once for all tests.
paperReader :: Reader
paperReader = either (error . show) id (readerOf <$> paperAlphabet <*> paperNetwork)

paperTables :: LatticeTables
paperTables = readerTables paperReader

arrange :: StitchMethod -> Registration -> [(Taxels, Raster)] -> Either TooMuch Arrangement
arrange method settings = Arrangement.arrange paperTables method settings (0, 0) . map (fmap whole)

assemble :: StitchMethod -> Registration -> [Frame] -> Either StitchError Assembly
assemble = Registration.assemble paperTables

stitch :: Registration -> [Frame] -> Either StitchError Composite
stitch = Registration.stitch paperTables

stitchedBy :: Stitching -> [Frame] -> Either StitchError Composite
stitchedBy = Stitching.stitchedBy paperTables
